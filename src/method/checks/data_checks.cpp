#include "method/checks/data_checks.h"

#include "method/checks/check_list.h"

namespace tribolog::method::checks {

DataChecksResult check_recordings(const joint::Dataset& dataset) {
  constexpr DataCheck (*in_order[])(const CheckedDataset&) = {
      check_effort_provenance,   check_angle_provenance,
      check_speed_provenance,    check_effort_column,
      check_link_side_torque,    check_joint_moves,
      check_angle_unit,          check_motor_speed,
      check_angle_jumps,         check_clock_jitter,
      check_clock_gaps,          check_angle_interpolated,
      check_torque_interpolated, check_speed_scale,
      check_speed_noise,         check_sweep_directions,
      check_run_directions,      check_sweep_common_angles,
      check_run_common_angles,   check_run_speeds,
      check_stick_slip,          check_torque_alive,
      check_torque_held,         check_torque_noise,
      check_torque_saturation,   check_torque_step,
      check_dissipation,         check_power,
      check_friction_drift,      check_temperature,
      check_encoder_step,        check_oscillation_cycles,
      check_oscillation_slides,
  };
  const CheckedDataset data = look_at(dataset);
  DataChecksResult result;
  for (const auto& check : in_order) result.checks.push_back(check(data));
  return result;
}

void add_gravity_checks(const joint::Dataset& dataset, const GravityResults& gravity,
                        DataChecksResult& result) {
  const std::vector<DataCheck> of_gravity = gravity_checks(dataset, gravity);
  result.checks.insert(result.checks.end(), of_gravity.begin(), of_gravity.end());
}

}  // namespace tribolog::method::checks
