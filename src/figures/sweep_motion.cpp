#include "figures/sweep_motion.h"

#include <cstdint>
#include <string>
#include <vector>

#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "figures/sweep_traces.h"
#include "wording/axis_scale.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures {
namespace {

using wording::tr;
using wording::tr_count;

/// One signal over time; the legend stands in the first panel only.
render::figure::Panel signal_panel(const std::vector<SweepTrace>& sweeps, Signal signal,
                                   const std::string& quantity, const wording::AxisScale& scale,
                                   bool legend) {
  render::figure::Panel panel;
  panel.x.title = tr("time t [s]");
  panel.y.title = wording::axis_title(quantity, scale);
  panel.show_legend = legend;
  bool labelled = false;
  const auto add = [&](const std::vector<double>& t, const std::vector<double>& y,
                       const std::string& label, render::figure::Colour colour, double width_px) {
    const bool name_it = legend && !labelled;
    labelled =
        add_visible(panel, line(name_it ? label : "", t, shown(y, scale), colour, width_px)) ||
        labelled;
  };
  // The grey line runs through all samples, so that nothing seems missing between strokes.
  if (count(sweeps, Stroke::left_out) > 0) {
    for (const SweepTrace& sweep : sweeps) {
      add(sweep.t_s, sweep.*signal, tr("left out: rest, acceleration, reversal"),
          render::figure::palette::grey, 2.0);
    }
  }
  const auto add_used = [&](Stroke stroke, const std::string& label,
                            render::figure::Colour colour) {
    labelled = false;
    for (const Stretch& stretch : stretches_of(sweeps, stroke, &SweepTrace::t_s, signal)) {
      add(stretch.x, stretch.y, label, colour, 3.0);
    }
  };
  add_used(Stroke::rising, tr("used, q rising"), rising_colour);
  add_used(Stroke::falling, tr("used, q falling"), falling_colour);
  return panel;
}

double largest_in(const std::vector<SweepTrace>& sweeps, Signal signal) {
  return wording::extent_of(signal_of(sweeps, signal)).largest();
}

}  // namespace

std::optional<ReportFigure> sweep_motion_figure(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration) {
  const auto sweeps = sweep_traces(calibration.curves.rough, dataset, joint::Role::rough_sweep);
  const wording::Extent angles = wording::extent_of(signal_of(sweeps, &SweepTrace::q_rad));
  const wording::Extent torques = wording::extent_of(signal_of(sweeps, &SweepTrace::torque_Nm));
  if (angles.empty || torques.empty) return std::nullopt;

  ReportFigure out;
  out.paper_number = 11;
  out.id = "fig-11-rough-motion";
  out.title = tr("Rough sweep over time");
  out.stage = "cog_rough";
  const wording::AxisScale speed =
      wording::prefixed("rad/s", largest_in(sweeps, &SweepTrace::motor_speed_rad_s));
  const wording::AxisScale torque = wording::levelled("N·m", torques);
  out.figure.panels = {
      signal_panel(sweeps, &SweepTrace::q_rad, tr("joint angle q"), wording::degrees(), true),
      signal_panel(sweeps, &SweepTrace::motor_speed_rad_s,
                   wording::speed_quantity(dataset.manifest), speed, false),
      signal_panel(sweeps, &SweepTrace::torque_Nm, tr("driving torque T"), torque, false)};
  out.figure.panels_share_x = true;
  out.figure.height_px = 1300;

  const bool at_motor = wording::has_motor_side(dataset.manifest);
  const std::string low = wording::with_unit(angles.low, wording::degrees(), 3);
  const std::string high = wording::with_unit(angles.high, wording::degrees(), 3);
  const std::string fastest =
      wording::with_unit(largest_in(sweeps, &SweepTrace::motor_speed_rad_s), speed, 3);
  const std::size_t rising = count(sweeps, Stroke::rising);
  const std::size_t falling = count(sweeps, Stroke::falling);
  out.caption = at_motor
                    ? tr("The rough sweep from {low} to {high} with the motor at up to {fastest}.",
                         {{"low", low}, {"high", high}, {"fastest", fastest}})
                    : tr("The rough sweep from {low} to {high} with the joint at up to {fastest}.",
                         {{"low", low}, {"high", high}, {"fastest", fastest}});
  out.caption +=
      " " + tr("{used} of {samples} samples were used ({rising} with the angle rising, {falling} "
               "falling); at the others the joint rests, accelerates or reverses.",
               {{"used", rising + falling},
                {"samples", rising + falling + count(sweeps, Stroke::left_out)},
                {"rising", rising},
                {"falling", falling}});
  if (sweeps.size() > 1) {
    out.caption += " " + tr_count(static_cast<std::int64_t>(sweeps.size()),
                                  "{recordings} recording, one after the other.",
                                  "{recordings} recordings, one after the other.",
                                  {{"recordings", sweeps.size()}});
  }
  out.how_to_read =
      tr("Used samples should cover the whole stroke in both directions, and torque should follow "
         "a piece of a cosine over the stroke, with a step where the direction changes. Spikes, "
         "drift between equal strokes, or a torque that follows the speed instead of the angle "
         "mean that something other than gravity and friction was measured.");
  const wording::AxisScale newton_metre = wording::prefixed("N·m", torques.largest());
  const std::string lowest_torque = wording::with_unit(torques.low, newton_metre, 3);
  const std::string highest_torque = wording::with_unit(torques.high, newton_metre, 3);
  out.alt = at_motor
                ? tr("Three panels over time: joint angle from {low} to {high}, motor speed up to "
                     "{fastest} and driving torque from {lowest_torque} to {highest_torque}.",
                     {{"low", low},
                      {"high", high},
                      {"fastest", fastest},
                      {"lowest_torque", lowest_torque},
                      {"highest_torque", highest_torque}})
                : tr("Three panels over time: joint angle from {low} to {high}, joint speed up to "
                     "{fastest} and driving torque from {lowest_torque} to {highest_torque}.",
                     {{"low", low},
                      {"high", high},
                      {"fastest", fastest},
                      {"lowest_torque", lowest_torque},
                      {"highest_torque", highest_torque}});
  return out;
}

}  // namespace tribolog::figures
