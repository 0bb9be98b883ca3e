#include "method/checks/data_check.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tribolog::method::checks {

std::string to_string(CheckState state) {
  switch (state) {
    case CheckState::passed:
      return "passed";
    case CheckState::warns:
      return "warns";
    case CheckState::fails:
      return "fails";
    case CheckState::not_applicable:
      return "not_applicable";
  }
  return "unknown";
}

std::string to_string(CheckName name) {
  /// In the order of the enumeration.
  constexpr std::array keys{"effort_provenance",
                            "angle_provenance",
                            "speed_provenance",
                            "effort_column",
                            "link_side_torque",
                            "joint_moves",
                            "angle_unit",
                            "motor_speed",
                            "angle_jumps",
                            "clock_jitter",
                            "clock_gaps",
                            "angle_interpolated",
                            "torque_interpolated",
                            "speed_scale",
                            "speed_noise",
                            "sweep_directions",
                            "run_directions",
                            "sweep_common_angles",
                            "run_common_angles",
                            "run_speeds",
                            "stick_slip",
                            "torque_alive",
                            "torque_held",
                            "torque_noise",
                            "torque_saturation",
                            "torque_step",
                            "friction_dissipates",
                            "power",
                            "friction_drift",
                            "temperature",
                            "encoder_step",
                            "oscillation_cycles",
                            "oscillation_slides",
                            "oscillation_at_peak",
                            "gravity_within_torque",
                            "static_torque",
                            "torque_ripple",
                            "ripple_period"};
  return keys.at(static_cast<std::size_t>(name));
}

const DataCheck* DataChecksResult::find(CheckName name) const {
  const auto it = std::find_if(checks.begin(), checks.end(),
                               [&](const DataCheck& check) { return check.name == name; });
  return it == checks.end() ? nullptr : &*it;
}

bool DataChecksResult::fails(CheckName name) const {
  const DataCheck* check = find(name);
  return check != nullptr && check->state == CheckState::fails;
}

std::vector<const DataCheck*> DataChecksResult::in_state(CheckState state) const {
  std::vector<const DataCheck*> found;
  for (const DataCheck& check : checks) {
    if (check.state == state) found.push_back(&check);
  }
  return found;
}

}  // namespace tribolog::method::checks
