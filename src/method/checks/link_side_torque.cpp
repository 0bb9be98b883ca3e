// A torque measured behind the gear holds the load, but little of the gear's friction.

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"

namespace tribolog {
namespace {

// A good planetary stage, up to a ratio of ten, passes on 97 % of its torque; strain wave gears
// lose more. What a joint's gear loses of the torque it carries is at least that.
constexpr double passed_on_by_ten = 0.97;
// Where the manifest states everything at the joint, as if there were no gear.
constexpr double usual_gear_ratio = 100;
constexpr double beside_spikes = 0.99;

double least_gear_loss_percent(double gear_ratio) {
  return 100 * (1 - std::pow(passed_on_by_ten, std::abs(std::log10(gear_ratio))));
}

/// The largest torque of the recordings, beside single spikes.
double largest_torque_Nm(const std::vector<const CheckedRecording*>& recordings) {
  std::vector<double> sizes;
  for (const CheckedRecording* r : recordings) {
    for (const double torque : r->recording->torque_Nm) sizes.push_back(std::abs(torque));
  }
  if (sizes.empty()) return 0;
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(
                                      beside_spikes * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

/// A logger that is known to measure behind the gear wrote at least one of the logs.
bool is_known_behind_gear(const CheckedDataset& data) {
  return std::any_of(data.inputs->begin(), data.inputs->end(), [](const InputFile& input) {
    return input.logged_effort && input.logged_effort->is_behind_gear;
  });
}

}  // namespace

DataCheck check_link_side_torque(const CheckedDataset& data) {
  DataCheck check;
  check.name = "link_side_torque";
  check.title = "Gear friction in a torque of the joint";
  const Drive& drive = data.manifest->drive;
  const bool behind_gear = is_known_behind_gear(data);
  const bool is_at_joint = drive.kind() == EffortKind::joint_torque && drive.side() == Side::joint;
  const bool has_gear = drive.gear_ratio() != 1 || behind_gear;
  if (!is_at_joint || !has_gear) {
    return not_applicable(check.name, check.title,
                          is_at_joint
                              ? "no gear lies between motor and joint"
                              : "the effort is not stated as a torque measured at the joint");
  }
  check.measure = "friction / largest torque, of the same recordings";
  check.unit = percent_sign;
  check.at_least =
      least_gear_loss_percent(drive.gear_ratio() != 1 ? drive.gear_ratio() : usual_gear_ratio);
  for (const Role role : {Role::rough_sweep, Role::precise_sweep, Role::constant_speed}) {
    const auto recordings = data.with_role(role);
    const DirectionDifference d = direction_difference(recordings, true);
    const double largest_Nm = largest_torque_Nm(recordings);
    if (d.common_bins == 0 || !(largest_Nm > 0)) continue;
    check.measured = 100 * d.friction_Nm / largest_Nm;
    check.recording = to_string(role);
    break;
  }
  const std::string behind = "friction behind the sensor, seen from the joint, is not in it";
  const bool is_as_a_gear = check.measured && *check.measured >= *check.at_least;
  if (is_as_a_gear && !behind_gear) {
    check.state = CheckState::passed;
    check.found = fmt::format(
        "friction is {:.3g} % of the largest torque, as much as a gear's: the torque looks like "
        "one computed from the motor's current; were it a sensor's, {}",
        *check.measured, behind);
    return check;
  }
  check.state = CheckState::warns;
  check.found =
      !check.measured
          ? "the torque is stated as that of the joint behind its gear; no recording has both "
            "directions over the same angles to tell how much friction is in it"
      : is_as_a_gear
          ? fmt::format(
                "the sensor sits behind the gear, and the torque still shows friction of "
                "{:.3g} % of its largest value: bearings, seals, cables",
                *check.measured)
          : fmt::format(
                "friction is only {:.3g} % of the largest torque; a gear loses {:.3g} % "
                "and more: the torque is measured behind it and contains little gear "
                "friction",
                *check.measured, *check.at_least);
  check.consequence =
      "mass and angle stand; friction, break-away torque and bristles are what the sensor feels: " +
      behind;
  check.experiment = "record the motor current beside it: their difference is the gear's friction";
  return check;
}

}  // namespace tribolog
