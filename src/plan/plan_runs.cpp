// Runs at constant speed, from below the Stribeck velocity to the fastest that fits.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "joint/degrees.h"
#include "plan/plan_builder.h"
#include "simulate/motion.h"

namespace tribolog::planning {
namespace {

constexpr double usual_speeds = 20;
constexpr double fewest_speeds = 8;
constexpr double most_speeds = 40;
constexpr double usual_plateau_s = 5;
constexpr double shortest_plateau_s = 0.2;
constexpr double largest_travel_rad = 60 * rad_per_degree;
constexpr double slowest_over_stribeck = 0.2;
constexpr double fastest_share = 0.95;  // of the speed limit
constexpr double usable_torque = 0.95;
/// Below this multiple of the Stribeck velocity the curve's rise is not seen.
constexpr double fastest_over_stribeck = 3;
constexpr double least_ratio_of_speeds = 2;

/// The fastest joint speed whose plateau and ramps fit the range, and whose torque the drive has.
struct Fastest {
  double speed_rad_s{};
  const char* limited_by{"speed limit"};
};

Fastest fastest_speed(const AssumedJoint& j, const WorkingRange& range) {
  const double n = j.facts.gear_ratio;
  Fastest fastest{fastest_share * j.facts.speed_limit_rad_s};
  const auto fits = [&](double v) {
    return v * shortest_plateau_s + 2 * TravelMotion::ramp_way_rad(v, range.acceleration_rad_s2) <=
           range.span_rad();
  };
  const auto is_driven = [&](double v) {
    return j.gravity_Nm + j.friction_Nm(n * v) + j.inertia_kgm2 * n * range.acceleration_rad_s2 <=
           usable_torque * j.facts.torque_limit_Nm;
  };
  const auto lower_to = [&](const auto& holds, const char* why) {
    if (holds(fastest.speed_rad_s)) return;
    double low = 0;
    double high = fastest.speed_rad_s;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      (holds(middle) ? low : high) = middle;
    }
    fastest = {low, why};
  };
  lower_to(fits, "angle range");
  // Where the drive cannot even start, less acceleration is a question of its own.
  if (is_driven(0)) lower_to(is_driven, "torque limit");
  return fastest;
}

void record_run(double speed_rad_s, std::size_t number, const WorkingRange& range,
                Timeline& timeline, ExperimentPlan& plan) {
  const AssumedJoint& j = plan.joint;
  const double ramps = 2 * TravelMotion::ramp_way_rad(speed_rad_s, range.acceleration_rad_s2);
  const double plateau_s = usual_plateau_s * std::max(plan.effort, shortest_plateau_s);
  const double plateau =
      std::min({largest_travel_rad, speed_rad_s * plateau_s, range.span_rad() - ramps});
  const double half_way = (plateau + ramps) / 2;
  const double centre = range.with_room(j.q_peak_rad, half_way);
  const double from = std::max(range.low_rad, centre - half_way);
  const double to = std::min(range.high_rad, centre + half_way);
  timeline.go_to(from);
  const auto motion = travel(from, to, speed_rad_s, range.acceleration_rad_s2, true, rest_s / 2);
  timeline.record(
      fmt::format("constant speed {}: {:.3g} rad/s", number, speed_rad_s * j.facts.gear_ratio),
      Role::constant_speed, motion, 0, motion->duration_s());
}

}  // namespace

void add_runs(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  const AssumedJoint& j = plan.joint;
  PlannedPart part;
  part.role = Role::constant_speed;
  part.gives = "friction against speed: Coulomb, Stribeck and viscous parameters";
  const double n = j.facts.gear_ratio;
  const Fastest fastest = fastest_speed(j, range);
  const double top = n * fastest.speed_rad_s;
  const double bottom = slowest_over_stribeck * j.stribeck_speed_rad_s;
  if (top < least_ratio_of_speeds * bottom) {
    part.state = PartState::impossible;
    part.why = fmt::format(
        "the {} allows {:.3g} rad/s at the motor, below {:.3g} rad/s where runs would begin "
        "(a fifth of the Stribeck velocity)",
        fastest.limited_by, top, bottom);
    part.help = std::string("a higher ") + fastest.limited_by;
    plan.parts.push_back(std::move(part));
    return;
  }
  if (top < fastest_over_stribeck * j.stribeck_speed_rad_s) {
    part.state = PartState::limited;
    part.why = fmt::format(
        "the {} allows {:.3g} rad/s at the motor, {:.2g} times the Stribeck velocity of {:.3g} "
        "rad/s: viscous friction cannot be told from the Stribeck fall",
        fastest.limited_by, top, top / j.stribeck_speed_rad_s, j.stribeck_speed_rad_s);
    part.help = fmt::format("{:.3g} rad/s at the motor and more",
                            fastest_over_stribeck * j.stribeck_speed_rad_s);
  }
  const auto count = static_cast<std::size_t>(
      std::clamp(std::round(usual_speeds * std::sqrt(plan.effort)), fewest_speeds, most_speeds));
  const double begins_s = timeline.now_s();
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count - 1);
    const double motor = bottom * std::pow(top / bottom, share);
    plan.motor_speeds_rad_s.push_back(motor);
    record_run(motor / n, k + 1, range, timeline, plan);
  }
  part.recordings = count;
  part.duration_s = timeline.now_s() - begins_s;
  part.motion = fmt::format(
      "{} speeds in both directions from {:.3g} to {:.3g} rad/s at the motor ({:.3g}°/s to "
      "{:.3g}°/s), the fastest by the {}",
      count, bottom, top, bottom / n * degrees_per_rad, top / n * degrees_per_rad,
      fastest.limited_by);
  plan.parts.push_back(std::move(part));
}

}  // namespace tribolog::planning
