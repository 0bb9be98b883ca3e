#pragma once
// What is known of a robot for the drawings of a report.

#include <optional>
#include <vector>

#include "joint/gravity_load.h"
#include "robot/joint_under_test.h"

namespace tribolog {

/// Joint angles from the lowest to the highest.
struct AngleRange {
  double lowest_rad{};
  double highest_rad{};
};

struct RobotDescription {
  JointUnderTest under_test;
  std::vector<double> portrait_rad;  ///< Angle of every joint in the picture of the whole robot.
  bool approximate{true};            ///< Whether the dimensions are; captions then say so.
  std::optional<AngleRange> range;   ///< Motion during the test, where stated: not empty.
  std::optional<GravityLoad> load;   ///< m, r and q_peak of the driven links, where stated.
  double surrogate_distance_m{0.5};  ///< r_REPL > 0, to draw a load that is stated.
};

}  // namespace tribolog
