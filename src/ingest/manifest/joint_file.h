#pragma once
// A joint that is to be measured: what `tribolog plan` starts from. TOML, by a schema of its own.
//
//   schema = "tribolog-joint-1"
//   [robot]    name; serial (optional)
//   [joint]    name, gear_ratio (motor angle / joint angle)
//              lowest_deg, highest_deg, speed_limit_deg_s, acceleration_limit_deg_s2 (of the joint;
//              or _rad, _rad_s, _rad_s2)
//              motor_torque_limit_Nm | joint_torque_limit_Nm
//              motor_inertia_kgm2 (motor and gear, at the motor), arm_inertia_kgm2 (about the
//              joint's axis): both or neither
//   [gravity]  what is known of it: joint_torque_Nm | motor_torque_Nm (centre of gravity level),
//              q_peak_deg (or _rad)
//   [friction] static_Nm, coulomb_Nm, stribeck_speed_rad_s, bristle_stiffness_Nm_rad: at the motor
//   [log]      sample_rate_Hz, set_point_rate_Hz, encoder_counts_per_turn (of the motor),
//              torque_noise_Nm (standard deviation), torque_step_Nm: at the motor
//   [ripple]   amplitude_Nm (of each period, at the motor); periods_per_turn = [...] of the motor,
//              or pole_pairs and wave_generator = true | false, from which they follow
//   [effort]   kind = "motor_current" | "motor_torque" | "joint_torque", side = "motor" | "joint",
//              torque_constant_Nm_A: of the log that will be recorded
//   [budget]   time_s
//
// A whole robot's joints share a file, each in [[joints]] (robot_joints.h): [joints.gravity],
// [joints.friction] and so on add to what stands once for all.
//
// All tables but [robot] and [joint], and all keys in them, are optional: a plan names what it
// assumes instead.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "joint/joint_facts.h"

namespace tribolog::ingest::manifest {

/// @param joint of a whole robot's file, by name; empty: the file is a single joint's.
/// @throw InputError at file:line:column for whatever is missing, unknown, impossible or misspelt;
///        for a manifest of logs, which has its own schema; as document_of_joint().
joint::JointFacts parse_joint(std::string_view text, const std::string& file,
                              const std::string& joint = {});

/// The joints of a whole robot's file, in their order; none: it is a single joint's.
/// @throw InputError as joint_names().
std::vector<std::string> joints_to_plan(std::string_view text, const std::string& file);

/// The joint as a calibration's recordings show it, for a plan of what to record next: its limits
/// are what the joint did, of angle, speed and torque (30 % more, for what no plateau shows), and
/// an acceleration that reaches the speed within 0.2 s; with with_calibration().
/// @throw as with_calibration(); InputError where neither sweep nor run was recorded, or the torque
///        is in ampere.
joint::JointFacts recorded_joint(std::string_view calibration, const std::string& file);

inline constexpr std::uint64_t largest_joint_bytes = 1 << 20;

/// What a calibration adds: angle of the gravity peak, gravity torque, ripple periods, break-away
/// torque, bristle stiffness and Stribeck velocity, each only where it was identified. What the
/// file of the joint states wins, but for angle and torque of gravity, which were measured.
/// @param calibration text of a calibration.json. @param file its name, for messages.
/// @throw InputError if it is no calibration of tribolog, or is of another gear ratio.
joint::JointFacts with_calibration(joint::JointFacts facts, std::string_view calibration,
                                   const std::string& file);

}  // namespace tribolog::ingest::manifest
