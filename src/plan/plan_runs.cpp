// Runs at constant speed, from below the Stribeck velocity to the fastest that fits.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "joint/degrees.h"
#include "plan/plan_builder.h"
#include "simulate/motion.h"

namespace tribolog::plan {

namespace {

constexpr double usual_speeds = 20;
constexpr double fewest_speeds = 8;
constexpr double most_speeds = 40;
constexpr double usual_plateau_s = 5;
constexpr double shortest_plateau_s = 0.2;
constexpr double largest_travel_rad = 60 * joint::rad_per_degree;
constexpr double slowest_over_stribeck = 0.2;
constexpr double fastest_share = 0.95;  // of the speed limit
/// Below this multiple of the Stribeck velocity the curve's rise is not seen.
constexpr double fastest_over_stribeck = 3;
constexpr double least_ratio_of_speeds = 2;

/// The fastest joint speed whose plateau and ramps fit the range, and whose torque the drive has.
struct Fastest {
  double speed_rad_s{};
  const char* limited_by{"speed_limit"};  ///< As codes of what is said of it end.
  [[nodiscard]] Code code(const std::string& topic) const { return Code::of(topic + limited_by); }
};

Fastest fastest_speed(const AssumedJoint& j, const WorkingRange& range) {
  const double n = j.facts.gear_ratio;
  Fastest fastest{fastest_share * j.facts.speed_limit_rad_s};
  const auto fits = [&](double v) {
    return v * shortest_plateau_s +
               2 * simulate::TravelMotion::ramp_way_rad(v, range.acceleration_rad_s2) <=
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
  lower_to(fits, "angle_range");
  // Where the drive cannot even start, less acceleration is a question of its own.
  if (is_driven(0)) lower_to(is_driven, "torque_limit");
  return fastest;
}

void record_run(double speed_rad_s, std::size_t number, const WorkingRange& range,
                Timeline& timeline, ExperimentPlan& plan) {
  const AssumedJoint& j = plan.joint;
  const double ramps =
      2 * simulate::TravelMotion::ramp_way_rad(speed_rad_s, range.acceleration_rad_s2);
  const double plateau_s = usual_plateau_s * std::max(plan.effort, shortest_plateau_s);
  const double plateau =
      std::min({largest_travel_rad, speed_rad_s * plateau_s, range.span_rad() - ramps});
  const double half_way = (plateau + ramps) / 2;
  const double centre = range.with_room(j.q_peak_rad, half_way);
  const double from = std::max(range.low_rad, centre - half_way);
  const double to = std::min(range.high_rad, centre + half_way);
  timeline.go_to(from);
  const auto motion = travel(from, to, speed_rad_s, range.acceleration_rad_s2, true, rest_s / 2);
  timeline.record({"plan_segment.constant_speed",
                   {{"number", number}, {"motor_speed", speed_rad_s * j.facts.gear_ratio}}},
                  joint::Role::constant_speed, motion, 0, motion->duration_s());
}

}  // namespace

void add_runs(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  const AssumedJoint& j = plan.joint;
  PlannedPart part;
  part.role = joint::Role::constant_speed;
  part.gives = {"plan_gives.runs"};
  const double n = j.facts.gear_ratio;
  const Fastest fastest = fastest_speed(j, range);
  const double top = n * fastest.speed_rad_s;
  const double bottom = slowest_over_stribeck * j.stribeck_speed_rad_s;
  if (top < least_ratio_of_speeds * bottom) {
    part.state = PartState::impossible;
    part.why = {fastest.code("plan_no_runs_within."), {{"fastest", top}, {"slowest", bottom}}};
    part.help = fastest.code("plan_higher.");
    plan.parts.push_back(std::move(part));
    return;
  }
  if (top < fastest_over_stribeck * j.stribeck_speed_rad_s) {
    part.state = PartState::limited;
    part.why = {fastest.code("plan_slow_runs_within."),
                {{"fastest", top},
                 {"times", top / j.stribeck_speed_rad_s},
                 {"stribeck_speed", j.stribeck_speed_rad_s}}};
    part.help = {"plan_help.motor_speed",
                 {{"motor_speed", fastest_over_stribeck * j.stribeck_speed_rad_s}}};
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
  part.motion = {fastest.code("plan_runs_to."),
                 {{"speeds", count},
                  {"slowest", bottom},
                  {"fastest", top},
                  {"slowest_joint", bottom / n * joint::degrees_per_rad},
                  {"fastest_joint", top / n * joint::degrees_per_rad}}};
  plan.parts.push_back(std::move(part));
}

// Break-away ramps: the joint stands at the gravity peak, the torque rises until it slides.

namespace {

constexpr double seconds_to_break_away = 4;
constexpr double usual_change = 1.6;  // of the break-away torque
constexpr double least_change = 1.2;
constexpr double return_s = 2;
constexpr double usual_repeats = 5;
constexpr double fewest_repeats = 3;
constexpr double most_repeats = 10;
/// Travel at which a ramp is over, as a multiple of the deflection at break-away.
constexpr double travel_over_breakaway = 100;
/// The travel to break-away must show in so many steps of the encoder
/// (method/hysteresis/break_away.h).
constexpr double fewest_steps = 20;

}  // namespace

void add_ramps(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  using std::numbers::pi;
  const AssumedJoint& j = plan.joint;
  const double n = j.facts.gear_ratio;
  PlannedPart part = part_about_the_peak(joint::Role::break_away, range, plan);
  part.gives = {"plan_gives.ramps"};
  const double spare = usable_torque * j.facts.torque_limit_Nm - j.gravity_Nm;
  const double change = std::min(usual_change * j.static_Nm, spare);
  const double steps = j.breakaway_deflection_rad() * j.noise.encoder_counts_per_turn / (2 * pi);
  // Thrown off by all of the change it must not pass the speed limit within its travel.
  const double speed_limit = j.facts.speed_limit_rad_s * n;
  const double by_speed = speed_limit * speed_limit * j.inertia_kgm2 / (2 * change) / n;
  const double travel = std::min(
      {travel_over_breakaway * j.breakaway_deflection_rad() / n, by_speed, range.span_rad() / 2});
  if (part.state == PartState::planned && change < least_change * j.static_Nm) {
    part.state = PartState::impossible;
    part.why = {"plan_limit.torque_left_for_ramp",
                {{"gravity_torque", j.gravity_Nm},
                 {"torque_limit", j.facts.torque_limit_Nm},
                 {"torque_left", spare},
                 {"torque_needed", least_change * j.static_Nm},
                 {"break_away_torque", j.static_Nm}}};
    part.help = {"plan_help.lighter_load"};
  } else if (part.state == PartState::planned && steps < fewest_steps) {
    part.state = PartState::impossible;
    part.why = {"plan_limit.encoder_before_break_away",
                {{"deflection", j.breakaway_deflection_rad()},
                 {"steps", steps},
                 {"steps_needed", fewest_steps}}};
    part.help = {"plan_help.finer_encoder"};
  }
  if (part.state == PartState::planned) {
    const PlannedRamp up{1, j.static_Nm / seconds_to_break_away, change, travel};
    const double ramp_s = change / up.rate_Nm_s;
    const double q = range.with_room(j.q_peak_rad, travel);
    const auto repeats = static_cast<int>(std::clamp(
        std::round(usual_repeats * std::sqrt(plan.effort)), fewest_repeats, most_repeats));
    const double begins_s = timeline.now_s();
    timeline.go_to(q);
    for (int k = 0; k < 2 * repeats; ++k) {
      PlannedRamp ramp = up;
      ramp.direction = k % 2 == 0 ? 1 : -1;
      timeline.record({k % 2 == 0 ? Code("plan_segment.ramp_up") : Code("plan_segment.ramp_down"),
                       {{"number", k + 1}, {"ramps", 2 * repeats}}},
                      joint::Role::break_away, hold(q, rest_s + ramp_s + return_s), rest_s,
                      rest_s + ramp_s, ramp);
    }
    part.recordings = static_cast<std::size_t>(2 * repeats);
    part.duration_s = timeline.now_s() - begins_s;
    part.motion = {"plan_motion.ramps",
                   {{"angle", degrees_text(q)},
                    {"ramps", repeats},
                    {"rate", up.rate_Nm_s},
                    {"change", change},
                    {"travel", travel * joint::degrees_per_rad}}};
  }
  plan.parts.push_back(std::move(part));
}

// The two sweeps.

namespace {

constexpr double rough_stroke_s = 70;
constexpr double precise_stroke_s = 20;
constexpr double precise_reach_rad = 1 * joint::rad_per_degree;  // as in the paper
constexpr double least_precise_reach_rad = 0.25 * joint::rad_per_degree;
constexpr double least_range_rad = 20 * joint::rad_per_degree;
constexpr double good_range_rad = 60 * joint::rad_per_degree;
constexpr double fastest_sweep_share = 0.25;  // of the speed limit

double sweep_speed(const ExperimentPlan& plan, double way_rad, double stroke_s) {
  return std::min(way_rad / (stroke_s * plan.effort),
                  fastest_sweep_share * plan.joint.facts.speed_limit_rad_s);
}

void add_sweep(Code name, double from_rad, double to_rad, double speed_rad_s,
               const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan,
               PlannedPart& part) {
  const double begins_s = timeline.now_s();
  timeline.go_to(from_rad);
  const auto motion =
      travel(from_rad, to_rad, speed_rad_s, range.acceleration_rad_s2, true, rest_s);
  timeline.record(name, part.role, motion, 0, motion->duration_s());
  part.recordings = 1;
  part.duration_s = timeline.now_s() - begins_s;
  part.motion = {"plan_motion.sweep",
                 {{"start", degrees_text(from_rad)},
                  {"end", degrees_text(to_rad)},
                  {"joint_speed", speed_rad_s * joint::degrees_per_rad},
                  {"motor_speed", speed_rad_s * plan.joint.facts.gear_ratio}}};
}

}  // namespace

void add_rough_sweep(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  PlannedPart part;
  part.role = joint::Role::rough_sweep;
  part.gives = {"plan_gives.rough_sweep"};
  const double span = range.span_rad();
  if (span < least_range_rad) {
    part.state = PartState::impossible;
    part.why = {"plan_limit.range_too_small",
                {{"range", degrees_text(span, 1)}, {"needed", degrees_text(least_range_rad, 0)}}};
    part.help = {"plan_help.wider_angle_limits"};
  } else {
    if (span < good_range_rad) {
      part.state = PartState::limited;
      part.why = {"plan_limit.short_range",
                  {{"range", degrees_text(span, 1)}, {"good", degrees_text(good_range_rad, 0)}}};
      part.help = {"plan_help.wider_angle_limits"};
    } else if (plan.joint.peak_is_known && !range.holds_peak) {
      part.state = PartState::limited;
      part.why = {"plan_limit.peak_not_crossed", {{"peak", degrees_text(plan.joint.q_peak_rad)}}};
      part.help = {"plan_help.range_with_peak"};
    }
    add_sweep("plan_segment.rough_sweep", range.low_rad, range.high_rad,
              sweep_speed(plan, span, rough_stroke_s), range, timeline, plan, part);
  }
  plan.parts.push_back(std::move(part));
}

void add_precise_sweep(const WorkingRange& range, Timeline& timeline, ExperimentPlan& plan) {
  PlannedPart part = part_about_the_peak(joint::Role::precise_sweep, range, plan);
  part.gives = {"plan_gives.precise_sweep"};
  if (part.state == PartState::planned) {
    const double peak = plan.joint.q_peak_rad;
    const double reach = std::min({precise_reach_rad, peak - range.low_rad, range.high_rad - peak});
    if (reach < least_precise_reach_rad) {
      part.state = PartState::impossible;
      part.why = {"plan_limit.peak_at_end",
                  {{"peak", degrees_text(peak)},
                   {"distance", degrees_text(reach)},
                   {"needed", degrees_text(least_precise_reach_rad)}}};
      part.help = {"plan_help.wider_angle_limits"};
    } else {
      add_sweep("plan_segment.precise_sweep", peak - reach, peak + reach,
                sweep_speed(plan, 2 * reach, precise_stroke_s), range, timeline, plan, part);
    }
  }
  plan.parts.push_back(std::move(part));
}

}  // namespace tribolog::plan
