#pragma once
// The paper's drawings of the robot, figures 9, 10 and 12, made from a robot's description.

#include <vector>

#include "robot/robot_description.h"

#include "figures/report_figure.h"

namespace tribolog {

/// Figure 9: the robot itself with the axes of its joints.
ReportFigure robot_figure(const RobotDescription& robot);

/// Figure 10: its phenomenological model. Links, axes, the mass centre of what the tested joint
/// drives with its surrogate, their distances and angles, and gravity.
ReportFigure mass_model_figure(const RobotDescription& robot);

/// Figure 12: the range of motion of the tested joint, and the angle at which the mass centre is
/// level.
ReportFigure motion_range_figure(const RobotDescription& robot);

/// All three, in the order of their numbers.
std::vector<ReportFigure> scene_figures(const RobotDescription& robot);

}  // namespace tribolog
