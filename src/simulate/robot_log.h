#pragma once
// A robot's joints, simulated in one log: one joint after another makes its experiments, while the
// others hold their place against gravity. They do not act on each other.

#include <string>
#include <vector>

#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog::simulate {

struct RobotLog {
  /// One experiment of one joint, a part of the log.
  struct Part {
    joint::Role role{};
    double from_s{};
    double to_s{};
  };
  struct Joint {
    std::vector<double> q_rad;      ///< Of the arm's side.
    std::vector<double> torque_Nm;  ///< At the motor.
    std::vector<Part> parts;
  };
  std::vector<double> t_s;  ///< Of all joints alike.
  std::vector<Joint> joints;
};

/// The experiments of each, in the order of simulate_joint(). Between them the joint rests a
/// second, moves to the next one's first angle against its steady friction, and rests again.
/// @param scenarios of the joints, in the order in which they move.
/// @throw Refusal as simulate_joint(), and for samples that are lost or stamped beside their ticks,
///        as the joints share their clock.
RobotLog simulate_robot(const std::vector<Scenario>& scenarios);

}  // namespace tribolog::simulate
