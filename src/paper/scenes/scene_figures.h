#pragma once
// The paper's drawings of the robot, figures 9, 10 and 12, made from a robot's description.

#include <optional>
#include <vector>

#include "calibration/calibration.h"
#include "figures/report_figure.h"
#include "paper/scenes/scene_words.h"
#include "robot/joint_under_test.h"

namespace tribolog::paper::scenes {

/// Figure 9: the robot itself with the axes of its joints.
figures::ReportFigure robot_figure(const robot::RobotDescription& robot);

/// Figure 10: its phenomenological model. Links, axes, the mass centre of what the tested joint
/// drives where mass and distance are known, its surrogate, their distances and angles, and
/// gravity. Nothing without q_peak and the surrogate mass.
std::optional<figures::ReportFigure> mass_model_figure(const robot::RobotDescription& robot,
                                                       const TestNumbers& numbers);

/// Figure 12: the range of motion of the tested joint, and the angle at which the mass centre is
/// level. Nothing without q_peak and a range of up to one turn.
std::optional<figures::ReportFigure> motion_range_figure(const robot::RobotDescription& robot,
                                                         const TestNumbers& numbers);

/// Those that there are, in the order of their numbers, with what the description states.
std::vector<figures::ReportFigure> scene_figures(const robot::RobotDescription& robot);

/// The same with what was identified: the numbers of the description are not shown.
std::vector<figures::ReportFigure> scene_figures(const robot::RobotDescription& robot,
                                                 const calibration::Calibration& calibration);

/// A report's figures with the robot's put among them, in the order of the paper's numbers.
/// @param robot may be null: then nothing is added.
std::vector<figures::ReportFigure> with_scene_figures(std::vector<figures::ReportFigure> figures,
                                                      const robot::RobotDescription* robot,
                                                      const calibration::Calibration& calibration);

}  // namespace tribolog::paper::scenes
