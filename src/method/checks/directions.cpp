// Both directions, over the same angles: without them friction and what depends on the angle cannot
// be separated.

#include <algorithm>
#include <cmath>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"
#include "method/motion/plateaus.h"

namespace tribolog::method::checks {
namespace {

constexpr double least_share_percent = 10;

Code none_of(joint::Role role) {
  return role == joint::Role::constant_speed ? Code{"not_applicable.no_run"}
                                             : Code{"not_applicable.no_rough_sweep"};
}

/// The only direction in which the joint moved.
Code only_direction(joint::Role role, bool rises) {
  if (role == joint::Role::constant_speed) {
    return rises ? Code{"directions.runs_only_rise"} : Code{"directions.runs_only_fall"};
  }
  return rises ? Code{"directions.sweep_only_rises"} : Code{"directions.sweep_only_falls"};
}

DataCheck check_directions(const CheckedDataset& data, joint::Role role, CheckName name) {
  const auto recordings = data.with_role(role);
  if (recordings.empty()) {
    return not_applicable(name, none_of(role));
  }
  const DirectionDifference d = direction_difference(recordings, false);
  const double travel = d.rising_travel_rad + d.falling_travel_rad;
  if (!(travel > 0)) return not_applicable(name, {"not_applicable.joint_stands"});
  DataCheck check;
  check.name = name;
  check.recording = recordings.size() == 1 ? recordings.front()->recording->name : "all";
  check.measure = {"measure.rarer_direction"};
  check.unit = percent_sign;
  check.at_least = least_share_percent;
  check.measured = 100 * std::min(d.rising_travel_rad, d.falling_travel_rad) / travel;
  if (*check.measured >= least_share_percent) {
    check.state = CheckState::passed;
    check.found = {"directions.both_recorded"};
    return check;
  }
  check.state = CheckState::fails;
  check.found = only_direction(role, d.rising_travel_rad > d.falling_travel_rad);
  check.consequence = {"directions.constant_in_one_direction"};
  check.experiment = {"directions.record_the_way_back"};
  return check;
}

/// Share of the plateaus' travel that is also covered by a plateau of the opposite direction at the
/// same speed.
double share_with_a_partner(const std::vector<const CheckedRecording*>& recordings) {
  struct Travel {
    double speed, low, high;
  };
  std::vector<Travel> ways;
  for (const CheckedRecording* r : recordings) {
    for (const motion::Plateau& plateau : r->motion.plateaus) {
      const double first = r->recording->q_rad[plateau.first];
      const double last = r->recording->q_rad[plateau.last - 1];
      ways.push_back({plateau.speed_rad_s, std::min(first, last), std::max(first, last)});
    }
  }
  double shared = 0;
  double all = 0;
  for (const Travel& way : ways) {
    double best = 0;
    for (const Travel& other : ways) {
      if (std::abs(other.speed / way.speed + 1) > motion::same_speed) continue;
      best = std::max(best, std::min(way.high, other.high) - std::max(way.low, other.low));
    }
    shared += best;
    all += way.high - way.low;
  }
  return all > 0 ? shared / all : 0.0;
}

DataCheck check_common_angles(const CheckedDataset& data, joint::Role role, CheckName name) {
  constexpr double least_common_percent = 20;
  constexpr double practically_none_percent = 5;
  const auto recordings = data.with_role(role);
  if (recordings.empty()) {
    return not_applicable(name, none_of(role));
  }
  if (data.has_no_gravity()) return not_applicable(name, {"not_applicable.no_gravity"});
  const DirectionDifference d = direction_difference(recordings, false);
  if (!(d.rising_travel_rad > 0) || !(d.falling_travel_rad > 0)) {
    return not_applicable(name, {"not_applicable.one_direction"});
  }
  DataCheck check;
  check.name = name;
  check.recording = recordings.size() == 1 ? recordings.front()->recording->name : "all";
  const bool by_speed = role == joint::Role::constant_speed;
  check.measure = by_speed ? Statement{"measure.common_travel_at_same_speed"}
                           : Statement{"measure.common_angles"};
  check.unit = percent_sign;
  check.at_least = least_common_percent;
  check.measured = 100 * (by_speed ? share_with_a_partner(recordings) : d.common_share);
  if (*check.measured >= least_common_percent) {
    check.state = CheckState::passed;
    check.found = {"directions.share_angles", {{"share_percent", *check.measured}}};
    return check;
  }
  check.state = CheckState::fails;
  if (*check.measured < practically_none_percent) {
    check.found = by_speed ? Code{"directions.share_no_angle_at_same_speed"}
                           : Code{"directions.share_no_angle"};
  } else {
    check.found = {"directions.share_few_angles", {{"share_percent", *check.measured}}};
  }
  check.consequence = {"directions.no_difference_at_equal_angle"};
  check.experiment = {"directions.record_same_angles"};
  return check;
}

}  // namespace

DataCheck check_sweep_directions(const CheckedDataset& data) {
  return check_directions(data, joint::Role::rough_sweep, CheckName::sweep_directions);
}

DataCheck check_run_directions(const CheckedDataset& data) {
  return check_directions(data, joint::Role::constant_speed, CheckName::run_directions);
}

DataCheck check_sweep_common_angles(const CheckedDataset& data) {
  return check_common_angles(data, joint::Role::rough_sweep, CheckName::sweep_common_angles);
}

DataCheck check_run_common_angles(const CheckedDataset& data) {
  return check_common_angles(data, joint::Role::constant_speed, CheckName::run_common_angles);
}

}  // namespace tribolog::method::checks
