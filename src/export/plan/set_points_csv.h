#pragma once
// A plan as set points for the drive.

#include <string>

#include "plan/experiment_plan.h"

namespace tribolog {

/// CSV at the plan's rate of set points: t_s,q_rad,dq_rad_s,torque_mode,ramp_torque_Nm. One header
/// row, LF line ends; each number is the shortest that reads back to the same double. While
/// torque_mode is 1 the torque leads: ramp_torque_Nm, at the motor, is to be added to what the
/// drive holds as the mode begins, and q_rad is where the joint stands then. Else the angle leads
/// and ramp_torque_Nm is 0. The last row is the plan's last moment.
std::string set_points_csv(const ExperimentPlan& plan);

}  // namespace tribolog
