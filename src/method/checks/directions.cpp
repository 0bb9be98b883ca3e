// Both directions, over the same angles: without them friction and what depends on the angle
// cannot be told apart.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"

namespace tribolog::method::checks {
namespace {

constexpr double least_share_percent = 10;

const char* recordings_of(joint::Role role) {
  return role == joint::Role::constant_speed ? "runs at constant speed" : "rough sweep";
}

std::string none_of(joint::Role role) {
  return role == joint::Role::constant_speed ? "no run at constant speed was recorded"
                                             : "no rough sweep was recorded";
}

DataCheck check_directions(const CheckedDataset& data, joint::Role role, const std::string& name,
                           const std::string& title) {
  const auto recordings = data.with_role(role);
  if (recordings.empty()) {
    return not_applicable(name, title, none_of(role));
  }
  const DirectionDifference d = direction_difference(recordings, false);
  const double travel = d.rising_travel_rad + d.falling_travel_rad;
  if (!(travel > 0)) return not_applicable(name, title, "the joint does not move");
  DataCheck check;
  check.name = name;
  check.title = title;
  check.recording = recordings.size() == 1 ? recordings.front()->recording->name : "all";
  check.measure = "share of the rarer direction in the travel";
  check.unit = percent_sign;
  check.at_least = least_share_percent;
  check.measured = 100 * std::min(d.rising_travel_rad, d.falling_travel_rad) / travel;
  if (*check.measured >= least_share_percent) {
    check.state = CheckState::passed;
    check.found = "both directions were recorded";
    return check;
  }
  check.state = CheckState::fails;
  check.found = fmt::format(
      "the joint only ever {} in the {}: Coulomb friction and offset cannot be told "
      "apart",
      d.rising_travel_rad > d.falling_travel_rad ? "rises" : "falls", recordings_of(role));
  check.consequence =
      "both are a constant torque while the direction is one; and friction that changes with the "
      "angle would be taken for gravity";
  check.experiment = "record the same motion back, over the same angles at the same speed";
  return check;
}

/// Share of the plateaus' travel that another plateau of the opposite direction and the same speed
/// passed too.
double share_with_a_partner(const std::vector<const CheckedRecording*>& recordings) {
  constexpr double same_speed = 0.05;
  struct Way {
    double speed, low, high;
  };
  std::vector<Way> ways;
  for (const CheckedRecording* r : recordings) {
    for (const motion::Plateau& plateau : r->motion.plateaus) {
      const double first = r->recording->q_rad[plateau.first];
      const double last = r->recording->q_rad[plateau.last - 1];
      ways.push_back({plateau.speed_rad_s, std::min(first, last), std::max(first, last)});
    }
  }
  double shared = 0;
  double all = 0;
  for (const Way& way : ways) {
    double best = 0;
    for (const Way& other : ways) {
      if (std::abs(other.speed / way.speed + 1) > same_speed) continue;
      best = std::max(best, std::min(way.high, other.high) - std::max(way.low, other.low));
    }
    shared += best;
    all += way.high - way.low;
  }
  return all > 0 ? shared / all : 0.0;
}

DataCheck check_common_angles(const CheckedDataset& data, joint::Role role, const std::string& name,
                              const std::string& title) {
  constexpr double least_common_percent = 20;
  constexpr double practically_none_percent = 5;
  const auto recordings = data.with_role(role);
  if (recordings.empty()) {
    return not_applicable(name, title, none_of(role));
  }
  const DirectionDifference d = direction_difference(recordings, false);
  if (!(d.rising_travel_rad > 0) || !(d.falling_travel_rad > 0)) {
    return not_applicable(name, title, "only one direction was recorded");
  }
  DataCheck check;
  check.name = name;
  check.title = title;
  check.recording = recordings.size() == 1 ? recordings.front()->recording->name : "all";
  const bool by_speed = role == joint::Role::constant_speed;
  check.measure = by_speed ? "share of the travel that both directions passed at the same speed"
                           : "share of the angles that both directions passed";
  check.unit = percent_sign;
  check.at_least = least_common_percent;
  check.measured = 100 * (by_speed ? share_with_a_partner(recordings) : d.common_share);
  if (*check.measured >= least_common_percent) {
    check.state = CheckState::passed;
    check.found = fmt::format("the directions share {:.0f} % of their angles", *check.measured);
    return check;
  }
  check.state = CheckState::fails;
  check.found =
      *check.measured < practically_none_percent
          ? "the directions share no angle" + std::string(by_speed ? " at the same speed" : "")
          : fmt::format("the directions share only {:.1f} % of their angles", *check.measured);
  check.consequence =
      "half the difference of the directions at equal angle, which gravity cannot enter, is not to "
      "be had: friction rests on the model of gravity, and nothing in these data checks it";
  check.experiment = "record both directions over the same angles";
  return check;
}

}  // namespace

DataCheck check_sweep_directions(const CheckedDataset& data) {
  return check_directions(data, joint::Role::rough_sweep, "sweep_directions",
                          "Both directions in the sweep");
}

DataCheck check_run_directions(const CheckedDataset& data) {
  return check_directions(data, joint::Role::constant_speed, "run_directions",
                          "Both directions in the runs");
}

DataCheck check_sweep_common_angles(const CheckedDataset& data) {
  return check_common_angles(data, joint::Role::rough_sweep, "sweep_common_angles",
                             "Common angles of the sweep's directions");
}

DataCheck check_run_common_angles(const CheckedDataset& data) {
  return check_common_angles(data, joint::Role::constant_speed, "run_common_angles",
                             "Common angles of the runs' directions");
}

}  // namespace tribolog::method::checks
