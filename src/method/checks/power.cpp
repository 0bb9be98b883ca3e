// What power says: friction takes it up, and a joint has only so much of it.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"

namespace tribolog {

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
  for (const Role role :
       {Role::rough_sweep, Role::precise_sweep, Role::oscillation, Role::constant_speed}) {
    const DirectionDifference d = direction_difference(data.with_role(role), true);
    if (d.common_bins == 0) continue;
    ++all;
    if (d.friction_Nm < -d.half_width_Nm) ++wrong;
    if (check.measured && d.friction_Nm >= *check.measured) continue;
    check.measured = d.friction_Nm;
    check.recording = to_string(role);
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

}  // namespace tribolog
