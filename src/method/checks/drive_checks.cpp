// A torque measured behind the gear includes the load, but little of the gear's friction.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::checks {

namespace {

// A good planetary stage, up to a ratio of ten, transmits 97 % of its torque; strain wave gears
// lose more. A joint's gear loses at least that share of the torque it carries.
constexpr double passed_on_by_ten = 0.97;
// Assumed where the manifest states everything at the joint, as if there were no gear.
constexpr double usual_gear_ratio = 100;
constexpr double beside_spikes = 0.99;

double least_gear_loss_percent(double gear_ratio) {
  return 100 * (1 - std::pow(passed_on_by_ten, std::abs(std::log10(gear_ratio))));
}

/// The largest torque of the recordings, apart from single spikes.
double largest_torque_Nm(const std::vector<const CheckedRecording*>& recordings) {
  std::vector<double> sizes;
  for (const CheckedRecording* r : recordings) {
    for (const double torque : r->recording->torque_Nm) sizes.push_back(std::abs(torque));
  }
  return sizes.empty() ? 0 : statistics::value_at_share(std::move(sizes), beside_spikes);
}

/// A logger that is known to measure behind the gear wrote at least one of the logs.
bool is_known_behind_gear(const CheckedDataset& data) {
  return std::any_of(data.inputs->begin(), data.inputs->end(), [](const joint::InputFile& input) {
    return input.logged_effort && input.logged_effort->is_behind_gear;
  });
}

}  // namespace

DataCheck check_link_side_torque(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::link_side_torque;
  const joint::Drive& drive = data.manifest->drive;
  const bool behind_gear = is_known_behind_gear(data);
  const bool is_at_joint =
      drive.kind() == joint::EffortKind::joint_torque && drive.side() == joint::Side::joint;
  const bool has_gear = drive.gear_ratio() != 1 || behind_gear;
  if (!is_at_joint || !has_gear) {
    return not_applicable(check.name, is_at_joint ? Code{"not_applicable.no_gear"}
                                                  : Code{"not_applicable.no_joint_torque"});
  }
  check.measure = {"measure.friction_of_largest_torque"};
  check.unit = percent_sign;
  check.at_least =
      least_gear_loss_percent(drive.gear_ratio() != 1 ? drive.gear_ratio() : usual_gear_ratio);
  for (const joint::Role role :
       {joint::Role::rough_sweep, joint::Role::precise_sweep, joint::Role::constant_speed}) {
    const auto recordings = data.with_role(role);
    const DirectionDifference d = direction_difference(recordings, true);
    const double largest_Nm = largest_torque_Nm(recordings);
    if (d.common_bins == 0 || !(largest_Nm > 0)) continue;
    check.measured = 100 * d.friction_Nm / largest_Nm;
    check.recording = joint::to_string(role);
    break;
  }
  const bool is_as_a_gear = check.measured && *check.measured >= *check.at_least;
  if (is_as_a_gear && !behind_gear) {
    check.state = CheckState::passed;
    check.found = {"link_side.friction_of_a_gear", {{"friction_percent", *check.measured}}};
    return check;
  }
  check.state = CheckState::warns;
  if (!check.measured) {
    check.found = {"link_side.friction_unknown"};
  } else if (is_as_a_gear) {
    check.found = {"link_side.friction_in_sensor", {{"friction_percent", *check.measured}}};
  } else {
    check.found = {"link_side.little_friction",
                   {{"friction_percent", *check.measured}, {"gear_loss_percent", *check.at_least}}};
  }
  check.consequence = {"link_side.friction_as_sensor_feels"};
  check.experiment = {"link_side.record_current"};
  return check;
}

// What power shows: friction dissipates it, and a joint has only so much of it.

DataCheck check_dissipation(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::friction_dissipates;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.half_difference"};
  check.unit = "N·m";
  check.at_least = 0;
  std::size_t wrong = 0;
  std::size_t all = 0;
  for (const joint::Role role : {joint::Role::rough_sweep, joint::Role::precise_sweep,
                                 joint::Role::oscillation, joint::Role::constant_speed}) {
    const DirectionDifference d = direction_difference(data.with_role(role), true);
    if (d.common_bins == 0) continue;
    ++all;
    if (d.friction_Nm < -d.half_width_Nm) ++wrong;
    if (check.measured && d.friction_Nm >= *check.measured) continue;
    check.measured = d.friction_Nm;
    check.recording = joint::to_string(role);
  }
  if (!check.measured) {
    return not_applicable(check.name, {"not_applicable.no_common_angles"});
  }
  if (wrong == 0) {
    check.state = CheckState::passed;
    check.found = {"dissipation.rising_takes_more"};
    return check;
  }
  check.state = CheckState::fails;
  if (wrong == all && all > 1) check.recording = "all";
  check.found = {"dissipation.friction_negative", {{"friction_Nm", *check.measured}}};
  check.consequence = {"dissipation.signs_wrong"};
  check.experiment = {"dissipation.state_sign"};
  return check;
}

DataCheck check_power(const CheckedDataset& data) {
  // The largest drives of robot joints are of some 15 kW.
  constexpr double largest_likely_kW = 50;
  DataCheck check;
  check.name = CheckName::power;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.largest_power"};
  check.unit = "kW";
  check.at_most = largest_likely_kW;
  const double n = data.manifest->drive.gear_ratio();
  for (const CheckedRecording& r : data.recordings) {
    double power = 0;
    for (std::size_t i = 0; i < r.recording->size(); ++i) {
      power =
          std::max(power, std::abs(r.recording->torque_Nm[i] * n * r.motion.speed_rad_s[i]) / 1000);
    }
    take_if_worst(check, power, r.recording->name);
  }
  if (!check.measured) return not_applicable(check.name, {"not_applicable.no_recording"});
  check.found = {"power.at_most", {{"power_kW", *check.measured}}};
  check.state = passed_or_fails(check);
  if (check.state == CheckState::passed) return check;
  check.found = {"power.beyond_any_joint", {{"power_kW", *check.measured}}};
  check.consequence = {"power.torques_wrong"};
  check.experiment = {"power.state_unit_and_side"};
  return check;
}

}  // namespace tribolog::method::checks
