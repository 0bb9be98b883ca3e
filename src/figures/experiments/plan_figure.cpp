#include "figures/experiments/plan_figure.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "exports/experiment/plan_table.h"
#include "figures/report_figure.h"
#include "joint/degrees.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures::experiments {
namespace {

namespace colour = render::figure::palette;
using wording::tr;
using wording::tr_count;

struct PartLook {
  joint::Role role;
  render::figure::Colour colour;
};

const std::vector<PartLook> all_parts{{joint::Role::rough_sweep, colour::blue},
                                      {joint::Role::precise_sweep, colour::purple},
                                      {joint::Role::oscillation, colour::vermilion},
                                      {joint::Role::constant_speed, colour::green},
                                      {joint::Role::break_away, colour::orange}};

/// A signal at a time of the plan.
using Signal = double (*)(const plan::ExperimentPlan&, double t_s);

double angle_deg(const plan::ExperimentPlan& plan, double t) {
  return plan.angle_rad(t) * joint::degrees_per_rad;
}
double motor_speed(const plan::ExperimentPlan& plan, double t) {
  return plan.speed_rad_s(t) * plan.joint.facts.gear_ratio;
}
double ramp_torque(const plan::ExperimentPlan& plan, double t) {
  const plan::PlannedSegment& s = plan.segments[plan.segment_at(t)];
  const bool leads = s.ramp && t >= s.from_s && t < s.to_s;
  return leads ? s.ramp->direction * s.ramp->rate_Nm_s * (t - s.from_s) : 0;
}

/// A stretch of the signal, evenly sampled.
render::figure::Series stretch(const plan::ExperimentPlan& plan, Signal signal, double from_s,
                               double to_s, int samples, double t_factor) {
  render::figure::Series series;
  for (int i = 0; i <= samples; ++i) {
    const double t = from_s + (to_s - from_s) * i / samples;
    series.x.push_back(t * t_factor);
    series.y.push_back(signal(plan, t));
  }
  return series;
}

constexpr int samples_of_segment = 400;
constexpr double minutes_per_s = 1 / 60.0;

/// The signal over the whole time, with the recordings of some parts on top of it.
render::figure::Panel time_panel(const plan::ExperimentPlan& plan, const std::string& y_title,
                                 Signal signal, const std::vector<PartLook>& parts,
                                 bool with_legend) {
  render::figure::Panel panel;
  panel.x.title = tr("time t [min]");
  panel.y.title = y_title;
  panel.show_legend = with_legend;
  // By segments: a travel lasts a moment, and its peak must not fall between two samples.
  render::figure::Series between;
  for (const plan::PlannedSegment& s : plan.segments) {
    const render::figure::Series part =
        stretch(plan, signal, s.start_s, s.end_s(), samples_of_segment, minutes_per_s);
    between.x.insert(between.x.end(), part.x.begin(), part.x.end());
    between.y.insert(between.y.end(), part.y.begin(), part.y.end());
  }
  between.label = with_legend ? tr("travel and rest") : "";
  between.colour = colour::grey;
  between.width_px = 2;
  add_visible(panel, std::move(between));
  for (const PartLook& look : parts) {
    bool is_first = true;
    for (const plan::PlannedSegment& s : plan.segments) {
      if (s.role != look.role) continue;
      render::figure::Series series =
          stretch(plan, signal, s.from_s, s.to_s, samples_of_segment, minutes_per_s);
      if (is_first && with_legend) series.label = exports::experiment::part_title(look.role);
      is_first = false;
      series.colour = look.colour;
      series.width_px = 3.5;
      add_visible(panel, std::move(series));
    }
  }
  return panel;
}

ReportFigure motion_figure(const plan::ExperimentPlan& plan) {
  ReportFigure out;
  out.id = "plan-motion";
  out.title = tr("The plan over time");
  out.stage = "plan";
  out.figure.panels = {
      time_panel(plan, tr("joint angle q [°]"), angle_deg, all_parts, true),
      time_panel(plan, tr("motor speed dφ/dt [rad/s]"), motor_speed, all_parts, false)};
  const bool has_ramps = plan.part(joint::Role::break_away).recordings > 0;
  if (has_ramps) {
    out.figure.panels.push_back(
        time_panel(plan, tr("ramp torque, motor [N·m]"), ramp_torque, {all_parts.back()}, false));
  }
  out.figure.panels_share_x = true;
  out.figure.height_px = has_ramps ? 1400 : 1050;
  std::vector<std::string> parts;
  for (const plan::PlannedPart& part : plan.parts) {
    if (part.recordings == 0) continue;
    parts.push_back(fmt::format("{} ({})", exports::experiment::part_title(part.role),
                                exports::experiment::duration_text(part.duration_s)));
  }
  const std::string duration = exports::experiment::duration_text(plan.duration_s());
  out.caption = tr("{duration} in all: {parts}.",
                   {{"duration", duration}, {"parts", wording::listed(parts)}});
  out.how_to_read =
      tr("Coloured: what is recorded and identified; grey: travel and rest in between.");
  if (!plan.positions_rad.empty()) {
    out.how_to_read += " " + tr("The oscillations are too small to be seen at this scale.");
  }
  if (has_ramps) {
    out.how_to_read +=
        " " + tr("During the ramps the set angle stays constant while the torque rises.");
  }
  out.alt = has_ramps ? tr("3 panels over {duration}: joint angle, motor speed and ramp torque.",
                           {{"duration", duration}})
                      : tr("2 panels over {duration}: joint angle, motor speed.",
                           {{"duration", duration}});
  return out;
}

std::optional<ReportFigure> oscillation_figure(const plan::ExperimentPlan& plan) {
  const auto first = std::find_if(
      plan.segments.begin(), plan.segments.end(),
      [](const plan::PlannedSegment& s) { return s.role == joint::Role::oscillation; });
  if (first == plan.segments.end()) return std::nullopt;
  const double from = std::max(0.0, first->start_s - 0.1);
  const double period = 1 / plan.frequency_Hz;
  const double to = std::min(first->end_s(), first->from_s + 3 * period);
  const double centre = plan.positions_rad.front();
  ReportFigure out;
  out.id = "plan-oscillation";
  out.title = tr("Start of the first oscillation");
  out.stage = "plan";
  render::figure::Panel panel;
  panel.x.title = tr("time t [s]");
  panel.y.title = fmt::format("q − ({}) [µrad]",
                              wording::significant(centre * joint::degrees_per_rad, 6) + "°");
  render::figure::Series before =
      stretch(plan, angle_deg, from, first->from_s, samples_of_segment, 1);
  before.label = tr("travel, rest and start");
  before.colour = colour::grey;
  render::figure::Series recorded =
      stretch(plan, angle_deg, first->from_s, to, 4 * samples_of_segment, 1);
  recorded.label = tr("recorded: whole cycles of a sine");
  recorded.colour = colour::vermilion;
  recorded.width_px = 3.5;
  for (render::figure::Series* s : {&before, &recorded}) {
    for (double& y : s->y) y = (y * joint::rad_per_degree - centre) * 1e6;
    add_visible(panel, std::move(*s));
  }
  out.figure.panels = {std::move(panel)};
  out.figure.height_px = 700;
  const std::size_t oscillations = plan.part(joint::Role::oscillation).recordings;
  const double motor_amplitude_rad = plan.amplitude_rad * plan.joint.facts.gear_ratio;
  out.caption = tr_count(
      static_cast<std::int64_t>(oscillations),
      "Three cycles of the first of {oscillations} oscillation: amplitude {amplitude} µrad at the "
      "joint, {motor_amplitude} mrad at the motor, {frequency} Hz.",
      "Three cycles of the first of {oscillations} oscillations: amplitude {amplitude} µrad at the "
      "joint, {motor_amplitude} mrad at the motor, {frequency} Hz.",
      {{"oscillations", oscillations},
       {"amplitude", wording::significant(plan.amplitude_rad * 1e6, 3)},
       {"motor_amplitude", wording::significant(motor_amplitude_rad * 1e3, 3)},
       {"frequency", wording::significant(plan.frequency_Hz, 3)}});
  out.how_to_read =
      tr("The speed rises from rest without a jump before the first recorded cycle and falls to "
         "rest after the last. The log must show such a sine; with a drive that smooths its set "
         "points, or a joint that sticks within its backlash, it does not.");
  out.alt = tr("Joint angle over time: rest, a short smooth start, then a sine.");
  return out;
}

}  // namespace

std::vector<ReportFigure> plan_figures(const plan::ExperimentPlan& plan) {
  if (plan.segments.empty()) return {};
  std::vector<ReportFigure> all{motion_figure(plan)};
  if (auto close = oscillation_figure(plan)) all.push_back(std::move(*close));
  for (ReportFigure& figure : all) {
    figure.figure.id = figure.id;
    figure.figure.title = figure.title;
  }
  return all;
}

}  // namespace tribolog::figures::experiments
