#pragma once
// A plan on disk: set points for the drive, all of its numbers, and the manifest of the log to
// come.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "plan/expected_intervals.h"
#include "plan/experiment_plan.h"

namespace tribolog::exports::experiment {

/// A manifest with the plan's recordings as time windows of one log, planned_log_name, whose clock
/// starts with the plan. Columns are named as in the set points, with torque_Nm for the effort, in
/// SI; the user corrects names and units that the drive's log has otherwise.
std::string plan_dataset_toml(const plan::ExperimentPlan& plan);

/// The joint's file, to be edited and planned for again. parse_joint() reads it.
std::string joint_toml(const joint::JointFacts& facts);

/// A joint of a robot, with the directory of its files, relative to that of the robot.
struct PlannedJoint {
  std::string directory;
  const plan::ExperimentPlan* plan{};  ///< Never null.
};

/// The same of a whole robot: each joint's log is planned_log_name in its directory.
std::string plan_robot_toml(const std::vector<PlannedJoint>& joints);

// A plan as set points for the drive.

/// CSV at the plan's rate of set points: t_s,q_rad,dq_rad_s,torque_mode,ramp_torque_Nm. One header
/// row, LF line ends; each number is the shortest that reads back to the same double. While
/// torque_mode is 1 the torque leads: ramp_torque_Nm, at the motor, is to be added to what the
/// drive holds as the mode begins, and q_rad is where the joint stands then. Else the angle leads
/// and ramp_torque_Nm is 0. The last row is the plan's last moment.
std::string set_points_csv(const plan::ExperimentPlan& plan);

// All numbers of a plan.

/// Schema "tribolog-plan-1": parts with their state, segments with their windows, assumptions, and
/// what to expect. SI, motor side unless a key says joint. The same plan gives the same bytes.
std::string plan_json(const plan::ExperimentPlan& plan, const plan::ExpectedIntervals& expected,
                      const calibration::Provenance& provenance);

}  // namespace tribolog::exports::experiment
