#pragma once
// Internal to the checks: each of them, in the order of the report; one source file per check or
// family of checks.

#include "method/checks/check_outcome.h"
#include "method/checks/checked_recordings.h"
#include "method/checks/data_checks.h"

namespace tribolog::method::checks {

// log_checks.cpp, drive_checks.cpp
DataCheck check_effort_provenance(const CheckedDataset& data);
DataCheck check_effort_column(const CheckedDataset& data);
DataCheck check_link_side_torque(const CheckedDataset& data);
// unit_provenance.cpp
DataCheck check_angle_provenance(const CheckedDataset& data);
DataCheck check_speed_provenance(const CheckedDataset& data);
// motion_checks.cpp
/// Does the sweeps' torque follow the cosine of the angle as read, over at least this range [rad]?
/// In a wrong unit it does not: over what is taken for many turns the torque bends once.
bool torque_follows_the_cosine(const CheckedDataset& data, double least_range_rad);
DataCheck check_joint_moves(const CheckedDataset& data);
DataCheck check_angle_unit(const CheckedDataset& data);
// angle_checks.cpp
DataCheck check_motor_speed(const CheckedDataset& data);
DataCheck check_angle_jumps(const CheckedDataset& data);
// log_checks.cpp
DataCheck check_clock_jitter(const CheckedDataset& data);
DataCheck check_clock_gaps(const CheckedDataset& data);
// slow_channels.cpp
DataCheck check_angle_interpolated(const CheckedDataset& data);
DataCheck check_torque_interpolated(const CheckedDataset& data);
// speed_checks.cpp
DataCheck check_speed_scale(const CheckedDataset& data);
DataCheck check_speed_noise(const CheckedDataset& data);
// directions.cpp
DataCheck check_sweep_directions(const CheckedDataset& data);
DataCheck check_run_directions(const CheckedDataset& data);
DataCheck check_sweep_common_angles(const CheckedDataset& data);
DataCheck check_run_common_angles(const CheckedDataset& data);
// speed_checks.cpp
DataCheck check_run_speeds(const CheckedDataset& data);
// motion_checks.cpp
DataCheck check_stick_slip(const CheckedDataset& data);
// torque_checks.cpp
DataCheck check_torque_alive(const CheckedDataset& data);
DataCheck check_torque_held(const CheckedDataset& data);
DataCheck check_torque_noise(const CheckedDataset& data);
DataCheck check_torque_saturation(const CheckedDataset& data);
DataCheck check_torque_step(const CheckedDataset& data);
// drive_checks.cpp
DataCheck check_dissipation(const CheckedDataset& data);
DataCheck check_power(const CheckedDataset& data);
// friction_drift.cpp, log_checks.cpp
DataCheck check_friction_drift(const CheckedDataset& data);
DataCheck check_temperature(const CheckedDataset& data);
// presliding_resolution.cpp
DataCheck check_encoder_step(const CheckedDataset& data);
// motion_checks.cpp
DataCheck check_oscillation_cycles(const CheckedDataset& data);
DataCheck check_oscillation_slides(const CheckedDataset& data);
// gravity_checks.cpp
std::vector<DataCheck> gravity_checks(const joint::Dataset& dataset, const GravityResults& gravity);

}  // namespace tribolog::method::checks
