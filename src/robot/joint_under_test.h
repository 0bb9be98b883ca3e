#pragma once
// The joint that is identified on its robot, and where gravity and the line of its link point.

#include <cstddef>
#include <optional>
#include <vector>

#include "joint/gravity_load.h"
#include "robot/serial_arm.h"

namespace tribolog::robot {

class JointUnderTest {
 public:
  struct Setting {
    std::size_t joint{};           ///< Index of the driven joint.
    std::vector<double> held_rad;  ///< Angle of every joint; that of the driven one is not used.
  };

  /// @throw Refusal if the joint does not exist, its axis is not horizontal in the
  /// pose it is held in (gravity torque would not follow the cosine of its angle alone), there is
  /// not one held angle for each joint, or one of another joint is outside its range.
  JointUnderTest(SerialArm arm, Setting setting);

  [[nodiscard]] const SerialArm& arm() const { return arm_; }
  [[nodiscard]] const Setting& setting() const { return setting_; }
  [[nodiscard]] const ArmJoint& joint() const { return arm_.joints()[setting_.joint]; }

  /// The arm with the driven joint at `q_rad`, also beyond its range of motion: a log says where
  /// the joint was.
  [[nodiscard]] ArmPose pose(double q_rad) const;
  /// The driven joint's place and its axis, which no motion under test changes; base's frame.
  [[nodiscard]] const Eigen::Vector3d& place_m() const { return place_m_; }
  [[nodiscard]] const Eigen::Vector3d& axis() const { return axis_; }
  /// Horizontal, at a right angle to the axis, on the side where positive turns raise: there
  /// gravity asks the largest torque. Unit vector.
  [[nodiscard]] Eigen::Vector3d level() const;
  /// Unit vector that is turned up from the level by an angle, about the axis.
  [[nodiscard]] Eigen::Vector3d above_level(double angle_rad) const;
  /// From the axis towards the mass centre: q - q_peak above the level. Unit vector.
  [[nodiscard]] Eigen::Vector3d towards_mass(double q_rad, double q_peak_rad) const;
  /// Torque about the axis that holds a load, from its lever and its weight in space [N·m].
  [[nodiscard]] double holding_torque_Nm(double q_rad, const joint::GravityLoad& load) const;
  /// Angle above the level of the driven link's own line where the joint stands at 0 [rad], from
  /// -pi to pi. The line is that axis of the link's frame (x, y or z, forwards or backwards) along
  /// which the flange lies farthest in the zero pose; 0 where the flange lies on the joint's axis.
  [[nodiscard]] double line_above_level_rad() const { return line_above_level_rad_; }

 private:
  SerialArm arm_;
  Setting setting_;
  double within_rad_{};  ///< An angle inside the driven joint's range.
  Eigen::Vector3d place_m_;
  Eigen::Vector3d axis_;
  double line_above_level_rad_{};
};

// What is known of a robot for the drawings of a report.

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
  std::optional<joint::GravityLoad> load;  ///< m, r and q_peak of the driven links, where stated.
  double surrogate_distance_m{0.5};        ///< r_REPL > 0, to draw a load that is stated.
};

}  // namespace tribolog::robot
