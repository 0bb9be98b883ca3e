#include "plan/plan_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "joint/degrees.h"

namespace tribolog::plan {
namespace {

constexpr double margin_share = 0.01;  // of the range, at either end
constexpr double largest_margin_rad = 1 * joint::rad_per_degree;
constexpr double travel_share = 0.5;  // of the speed limit
constexpr double acceleration_share = 0.5;
constexpr double least_acceleration_share = 1e-3;
constexpr double same_place_rad = 1e-12;

/// What is left of the torque limit for accelerating where gravity and friction ask the most.
double spare_torque_Nm(const AssumedJoint& j) {
  return usable_torque * j.facts.torque_limit_Nm - j.gravity_Nm - j.static_Nm;
}

struct Stretch {
  double low_rad{};
  double high_rad{};
  bool found{false};
};

/// Longest stretch over which the torque suffices; one that holds the peak comes first.
Stretch stretch_within_torque(const AssumedJoint& j, double low_rad, double high_rad) {
  constexpr int steps = 2000;
  const double allowed = usable_torque * j.facts.torque_limit_Nm - j.static_Nm;
  const auto suffices = [&](double q) {
    return j.gravity_Nm * std::abs(std::cos(q - j.q_peak_rad)) <= allowed;
  };
  Stretch best;
  Stretch now;
  for (int i = 0; i <= steps; ++i) {
    const double q = low_rad + (high_rad - low_rad) * i / steps;
    if (!suffices(q)) {
      now.found = false;
      continue;
    }
    if (!now.found) now = {q, q, true};
    now.high_rad = q;
    if (!best.found || now.high_rad - now.low_rad > best.high_rad - best.low_rad) best = now;
  }
  return best;
}

}  // namespace

double WorkingRange::with_room(double angle_rad, double room_rad) const {
  return std::max(low_rad + room_rad, std::min(angle_rad, high_rad - room_rad));
}

std::string degrees_text(double angle_rad, int decimals) {
  std::string text = fmt::format("{:.{}f}", angle_rad * joint::degrees_per_rad, decimals);
  if (text.front() == '-') text.replace(0, 1, "−");
  return text + "°";
}

WorkingRange working_range(const AssumedJoint& j, std::vector<Statement>& remarks) {
  const joint::JointFacts& f = j.facts;
  WorkingRange r;
  const double margin = std::min(largest_margin_rad, margin_share * (f.highest_rad - f.lowest_rad));
  r.low_rad = f.lowest_rad + margin;
  r.high_rad = f.highest_rad - margin;
  if (j.peak_is_known) {
    const Stretch s = stretch_within_torque(j, r.low_rad, r.high_rad);
    const bool is_all = s.found && s.low_rad <= r.low_rad && s.high_rad >= r.high_rad;
    if (!is_all) {
      const double torque_needed = (j.gravity_Nm + j.static_Nm) / usable_torque;
      remarks.push_back(s.found ? Statement{"plan.torque_holds_stretch",
                                            {{"torque_limit", f.torque_limit_Nm},
                                             {"gravity_torque", j.gravity_Nm},
                                             {"break_away_torque", j.static_Nm},
                                             {"lowest", degrees_text(s.low_rad)},
                                             {"highest", degrees_text(s.high_rad)},
                                             {"torque_needed", torque_needed}}}
                                : Statement{"plan.torque_holds_nowhere",
                                            {{"torque_limit", f.torque_limit_Nm},
                                             {"gravity_torque", j.gravity_Nm},
                                             {"break_away_torque", j.static_Nm},
                                             {"torque_needed", torque_needed}}});
    }
    r.low_rad = s.found ? s.low_rad : j.q_peak_rad;
    r.high_rad = s.found ? s.high_rad : j.q_peak_rad;
  } else if (spare_torque_Nm(j) < 0) {
    remarks.push_back({"plan.sweep_may_stall",
                       {{"gravity_torque", j.gravity_Nm},
                        {"break_away_torque", j.static_Nm},
                        {"torque_limit", f.torque_limit_Nm}}});
  }
  r.holds_peak = j.peak_is_known && j.q_peak_rad >= r.low_rad && j.q_peak_rad <= r.high_rad &&
                 r.high_rad > r.low_rad;
  const double by_torque = std::max(spare_torque_Nm(j) / (j.inertia_kgm2 * f.gear_ratio),
                                    least_acceleration_share * f.acceleration_limit_rad_s2);
  r.acceleration_rad_s2 = std::min(acceleration_share * f.acceleration_limit_rad_s2, by_torque);
  r.travel_speed_rad_s = travel_share * f.speed_limit_rad_s;
  return r;
}

void Timeline::go_to(double angle_rad) {
  if (has_place_ && std::abs(angle_rad - angle_rad_) > same_place_rad) {
    PlannedSegment s;
    s.name = {"plan_segment.travel"};
    s.start_s = now_s();
    s.motion = travel(angle_rad_, angle_rad, range_.travel_speed_rad_s, range_.acceleration_rad_s2,
                      false, rest_s / 2);
    plan_.segments.push_back(std::move(s));
  }
  has_place_ = true;
  angle_rad_ = angle_rad;
}

void Timeline::record(Statement name, joint::Role role, std::shared_ptr<const PlannedMotion> motion,
                      double from_s, double to_s, const std::optional<PlannedRamp>& ramp) {
  PlannedSegment s;
  s.name = std::move(name);
  s.role = role;
  s.start_s = now_s();
  s.from_s = s.start_s + from_s;
  s.to_s = s.start_s + to_s;
  s.ramp = ramp;
  angle_rad_ = motion->angle(motion->duration_s());
  s.motion = std::move(motion);
  plan_.segments.push_back(std::move(s));
}

PlannedPart part_about_the_peak(joint::Role role, const WorkingRange& range,
                                const ExperimentPlan& plan) {
  PlannedPart part;
  part.role = role;
  const AssumedJoint& j = plan.joint;
  if (!j.peak_is_known) {
    part.state = PartState::later;
    part.why = {"plan_limit.peak_unknown"};
    part.help = {"plan_help.plan_again"};
  } else if (!range.holds_peak) {
    part.state = PartState::impossible;
    part.why = {"plan_limit.peak_outside",
                {{"peak", degrees_text(j.q_peak_rad)},
                 {"lowest", degrees_text(range.low_rad)},
                 {"highest", degrees_text(range.high_rad)}}};
    part.help = {"plan_help.bring_peak_inside"};
  }
  return part;
}

}  // namespace tribolog::plan
