#include "figures/sweep_motion.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "figures/sweep_traces.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/shaft.h"

namespace tribolog::figures {
namespace {

/// One signal over time; the legend stands in the first panel only.
render::figure::Panel signal_panel(const std::vector<SweepTrace>& sweeps, Signal signal,
                                   const std::string& quantity, const wording::AxisScale& scale,
                                   bool legend) {
  render::figure::Panel panel;
  panel.x.title = "time t [s]";
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
      add(sweep.t_s, sweep.*signal, "left out: rest, acceleration, reversal",
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
  add_used(Stroke::rising, "used, q rising", rising_colour);
  add_used(Stroke::falling, "used, q falling", falling_colour);
  return panel;
}

double largest_in(const std::vector<SweepTrace>& sweeps, Signal signal) {
  return wording::extent_of(signal_of(sweeps, signal)).largest();
}

}  // namespace

std::optional<ReportFigure> sweep_motion_figure(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration) {
  const method::gravity::CogSweepResult& rough = calibration.rough;
  const auto sweeps = sweep_traces(rough, dataset, joint::Role::rough_sweep);
  const wording::Extent angles = wording::extent_of(signal_of(sweeps, &SweepTrace::q_rad));
  const wording::Extent torques = wording::extent_of(signal_of(sweeps, &SweepTrace::torque_Nm));
  if (angles.empty || torques.empty) return std::nullopt;

  ReportFigure out;
  out.number = 11;
  out.id = "fig-11-rough-motion";
  out.title = "Rough sweep over time";
  out.stage = "cog_rough";
  const wording::AxisScale speed =
      wording::prefixed("rad/s", largest_in(sweeps, &SweepTrace::motor_speed_rad_s));
  const wording::AxisScale torque = wording::levelled("N·m", torques);
  out.figure.panels = {
      signal_panel(sweeps, &SweepTrace::q_rad, "joint angle q", wording::degrees(), true),
      signal_panel(sweeps, &SweepTrace::motor_speed_rad_s,
                   wording::speed_quantity(dataset.manifest), speed, false),
      signal_panel(sweeps, &SweepTrace::torque_Nm, "driving torque T", torque, false)};
  out.figure.panels_share_x = true;
  out.figure.height_px = 1300;

  const std::string range = wording::with_unit(angles.low, wording::degrees(), 3) + " to " +
                            wording::with_unit(angles.high, wording::degrees(), 3);
  const std::string fastest =
      wording::with_unit(largest_in(sweeps, &SweepTrace::motor_speed_rad_s), speed, 3);
  const std::size_t rising = count(sweeps, Stroke::rising);
  const std::size_t falling = count(sweeps, Stroke::falling);
  out.caption = fmt::format(
      "The rough sweep from {} with the {} at up to {}. {} of {} samples were used ({} with the "
      "angle rising, {} falling); at the others the joint rests, accelerates or reverses.{}",
      range, wording::shaft(dataset.manifest), fastest, rising + falling,
      rising + falling + count(sweeps, Stroke::left_out), rising, falling,
      sweeps.size() > 1 ? fmt::format(" {} recordings, one after the other.", sweeps.size()) : "");
  out.how_to_read =
      "Used samples should cover the whole stroke in both directions, and torque should bend over "
      "the stroke as a piece of a cosine, with a step where the direction changes. Spikes, drift "
      "between equal strokes, or a torque that follows the speed instead of the angle mean that "
      "something other than gravity and friction was measured.";
  out.alt = fmt::format(
      "Three panels over time: joint angle from {}, {} speed up to {} and driving torque from "
      "{} to {}.",
      range, wording::shaft(dataset.manifest), fastest,
      wording::with_unit(torques.low, wording::prefixed("N·m", torques.largest()), 3),
      wording::with_unit(torques.high, wording::prefixed("N·m", torques.largest()), 3));
  return out;
}

}  // namespace tribolog::figures
