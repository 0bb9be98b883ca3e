// A torque measured behind the gear holds the load, but little of the gear's friction.

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"

namespace tribolog::method::checks {

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
  return std::any_of(data.inputs->begin(), data.inputs->end(), [](const joint::InputFile& input) {
    return input.logged_effort && input.logged_effort->is_behind_gear;
  });
}

}  // namespace

DataCheck check_link_side_torque(const CheckedDataset& data) {
  DataCheck check;
  check.name = "link_side_torque";
  check.title = "Gear friction in a torque of the joint";
  const joint::Drive& drive = data.manifest->drive;
  const bool behind_gear = is_known_behind_gear(data);
  const bool is_at_joint =
      drive.kind() == joint::EffortKind::joint_torque && drive.side() == joint::Side::joint;
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

// What power says: friction takes it up, and a joint has only so much of it.

DataCheck check_dissipation(const CheckedDataset& data) {
  DataCheck check;
  check.name = "friction_dissipates";
  check.title = "Friction takes up power";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "half the difference of the directions' torque at equal angle, motor side";
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
    return not_applicable(check.name, check.title,
                          "no recording has both directions over the same angles");
  }
  if (wrong == 0) {
    check.state = CheckState::passed;
    check.found = "rising takes more torque than falling at the same angle";
    return check;
  }
  check.state = CheckState::fails;
  if (wrong == all && all > 1) check.recording = "all";
  check.found = fmt::format(
      "friction is negative, {:.3g} N·m: the joint would gain power from it; the sign of the "
      "torque or of the angle is wrong",
      *check.measured);
  check.consequence =
      "gravity's peak is taken for its trough, half a turn away, and every "
      "friction torque has the wrong sign";
  check.experiment =
      "state effort.sign = -1, or the angle with the sign in which the torque "
      "drives it";
  return check;
}

DataCheck check_power(const CheckedDataset& data) {
  // The largest drives of robot joints are of some 15 kW.
  constexpr double largest_likely_kW = 50;
  DataCheck check;
  check.name = "power";
  check.title = "Power of a joint";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "largest torque times speed";
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
  if (!check.measured) return not_applicable(check.name, check.title, "no recording");
  check.found = fmt::format("at most {:.3g} kW", *check.measured);
  check.state = passed_or_fails(check);
  if (check.state == CheckState::passed) return check;
  check.found = fmt::format(
      "torque times speed reaches {:.3g} kW, which no robot's joint has: a torque in mN·m taken "
      "for N·m, a torque of the joint taken for the motor's, or a wrong gear ratio or torque "
      "constant?",
      *check.measured);
  check.consequence = "every torque and mass is wrong by the same factor";
  check.experiment = "state the unit and the side of the effort as they are";
  return check;
}

}  // namespace tribolog::method::checks
