// The two sweeps.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "plan/plan_builder.h"

namespace tribolog::planning {
namespace {

constexpr double rough_stroke_s = 70;
constexpr double precise_stroke_s = 20;
constexpr double precise_reach_rad = 1 * rad_per_degree;  // as in the paper
constexpr double least_precise_reach_rad = 0.25 * rad_per_degree;
constexpr double least_range_rad = 20 * rad_per_degree;
constexpr double good_range_rad = 60 * rad_per_degree;
constexpr double fastest_share = 0.25;  // of the speed limit

double sweep_speed(const ExperimentPlan& plan, double way_rad, double stroke_s) {
  return std::min(way_rad / (stroke_s * plan.effort),
                  fastest_share * plan.joint.facts.speed_limit_rad_s);
}

void add_sweep(const std::string& name, double from_rad, double to_rad, double speed_rad_s,
               const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan,
               PlannedPart& part) {
  const double begins_s = timeline.now_s();
  timeline.go_to(from_rad);
  const auto motion =
      travel(from_rad, to_rad, speed_rad_s, range.acceleration_rad_s2, true, rest_s);
  timeline.record(name, part.role, motion, 0, motion->duration_s());
  part.recordings = 1;
  part.duration_s = timeline.now_s() - begins_s;
  part.motion =
      fmt::format("from {} to {} and back at {:.3g}°/s, {:.3g} rad/s at the motor",
                  degrees_text(from_rad), degrees_text(to_rad), speed_rad_s * degrees_per_rad,
                  speed_rad_s * plan.joint.facts.gear_ratio);
}

}  // namespace

void add_rough_sweep(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  PlannedPart part;
  part.role = Role::rough_sweep;
  part.gives =
      "gravity torque, angle of the gravity peak, friction of the slow joint, torque ripple";
  const double span = range.span_rad();
  if (span < least_range_rad) {
    part.state = PartState::impossible;
    part.why = fmt::format(
        "over the {} that can be used a cosine cannot be told from a constant; {} are needed",
        degrees_text(span, 1), degrees_text(least_range_rad, 0));
    part.help = "wider angle limits";
  } else {
    if (span < good_range_rad) {
      part.state = PartState::limited;
      part.why = fmt::format(
          "{} is a short range: gravity is told from friction the less surely; {} and more are "
          "good",
          degrees_text(span, 1), degrees_text(good_range_rad, 0));
      part.help = "wider angle limits";
    } else if (plan.joint.peak_is_known && !range.holds_peak) {
      part.state = PartState::limited;
      part.why = fmt::format("the sweep does not cross the gravity peak at {}",
                             degrees_text(plan.joint.q_peak_rad));
      part.help = "an angle range that holds the peak";
    }
    add_sweep("rough sweep", range.low_rad, range.high_rad, sweep_speed(plan, span, rough_stroke_s),
              range, timeline, plan, part);
  }
  plan.parts.push_back(std::move(part));
}

void add_precise_sweep(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  PlannedPart part = part_about_the_peak(Role::precise_sweep, range, plan);
  part.gives = "angle of the gravity peak, closer";
  if (part.state == PartState::planned) {
    const double peak = plan.joint.q_peak_rad;
    const double reach = std::min({precise_reach_rad, peak - range.low_rad, range.high_rad - peak});
    if (reach < least_precise_reach_rad) {
      part.state = PartState::impossible;
      part.why = fmt::format(
          "the gravity peak at {} is {} from the end of the range; {} are needed",
          degrees_text(peak), degrees_text(reach), degrees_text(least_precise_reach_rad));
      part.help = "wider angle limits";
    } else {
      add_sweep("precise sweep", peak - reach, peak + reach,
                sweep_speed(plan, 2 * reach, precise_stroke_s), range, timeline, plan, part);
    }
  }
  plan.parts.push_back(std::move(part));
}

}  // namespace tribolog::planning
