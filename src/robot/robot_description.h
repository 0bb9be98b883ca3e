#pragma once
// What is known of a robot for the drawings of a report.

#include <vector>

#include "robot/joint_under_test.h"

namespace tribolog {

struct RobotDescription {
  JointUnderTest under_test;
  std::vector<double> portrait_rad;  ///< Angle of every joint in the picture of the whole robot.
  bool approximate{true};            ///< Whether the dimensions are; captions then say so.
};

}  // namespace tribolog
