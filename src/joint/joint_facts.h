#pragma once
// What is stated about a joint before it is measured. Everything SI.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "joint/drive.h"

namespace tribolog::joint {

/// Limits of the joint are never exceeded by a plan. What is absent is assumed, and the plan says
/// so (assumed_joint.h).
struct JointFacts {
  std::string robot;
  std::string serial;
  std::string joint;
  double gear_ratio{1.0};                      ///< n = motor angle / joint angle, > 0.
  double lowest_rad{};                         ///< Joint side.
  double highest_rad{};                        ///< > lowest_rad
  double speed_limit_rad_s{};                  ///< > 0, joint side.
  double acceleration_limit_rad_s2{};          ///< > 0, joint side.
  double torque_limit_Nm{};                    ///< > 0, motor side.
  std::optional<double> inertia_kgm2;          ///< Of motor, gear and arm at the motor shaft, > 0.
  std::optional<double> gravity_Nm;            ///< Largest gravity torque at the motor, > 0.
  std::optional<double> q_peak_rad;            ///< Joint angle at which it acts.
  std::optional<double> static_Nm;             ///< Break-away torque, motor side, > 0.
  std::optional<double> coulomb_Nm;            ///< > 0, <= static_Nm
  std::optional<double> stribeck_speed_rad_s;  ///< Of the motor, > 0.
  std::optional<double> bristle_stiffness_Nm_rad;    ///< > 0
  std::optional<double> sample_rate_Hz;              ///< Of the log, > 0.
  std::optional<double> set_point_rate_Hz;           ///< Of the set points, > 0.
  std::optional<double> encoder_counts_per_turn;     ///< Of the motor, > 0.
  std::optional<double> torque_noise_Nm;             ///< Standard deviation, motor side, >= 0.
  std::optional<double> torque_step_Nm;              ///< Motor side, >= 0.
  std::optional<double> ripple_amplitude_Nm;         ///< Of each period, motor side, >= 0.
  std::vector<double> ripple_periods_per_turn;       ///< Of the motor, > 0; empty: not known.
  std::optional<double> time_budget_s;               ///< > 0
  EffortKind effort_kind{EffortKind::motor_torque};  ///< Of the log to be recorded.
  Side effort_side{Side::motor};
  std::optional<double> torque_constant_Nm_A;  ///< With motor_current.
  /// Members above that an earlier calibration gave, by name: "q_peak_rad".
  std::set<std::string> identified;
};

/// @throw Refusal stating the value and the rule that it breaks.
void check_joint_facts(const JointFacts& facts);

}  // namespace tribolog::joint
