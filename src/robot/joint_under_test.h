#pragma once
// The joint that is identified, and what it carries: the mass centre of all links it moves, and the
// surrogate mass that asks the same torque.

#include <cstddef>
#include <vector>

#include "robot/serial_arm.h"

#include "joint/gravity_load.h"

namespace tribolog {

class JointUnderTest {
 public:
  struct Setting {
    std::size_t joint{};           ///< Index of the driven joint.
    std::vector<double> held_rad;  ///< Angle of every joint; that of the driven one is not used.
    double lowest_rad{};           ///< Range of motion during the test.
    double highest_rad{};
    double surrogate_distance_m{};    ///< r_REPL > 0
    GravityLoad load{1.0, 1.0, 0.0};  ///< m, r and q_peak of the driven links.
  };

  /// @throw std::invalid_argument if the joint does not exist, its axis is not horizontal in the
  /// pose it is held in (gravity torque would not follow the cosine of its angle alone), the range
  /// is empty or leaves the joint's own, the surrogate distance is not positive, or an angle is
  /// outside its range.
  JointUnderTest(SerialArm arm, Setting setting);

  [[nodiscard]] const SerialArm& arm() const { return arm_; }
  [[nodiscard]] const Setting& setting() const { return setting_; }
  [[nodiscard]] const GravityLoad& load() const { return setting_.load; }

  /// The arm with the driven joint at `q_rad`. @throw std::invalid_argument outside its range.
  [[nodiscard]] ArmPose pose(double q_rad) const;
  /// The driven joint's place and its axis, which no motion under test changes; base's frame.
  [[nodiscard]] Eigen::Vector3d place_m() const;
  [[nodiscard]] Eigen::Vector3d axis() const;
  /// Horizontal, at a right angle to the axis: where a link at angle 0 points from which q counts.
  [[nodiscard]] Eigen::Vector3d level() const;
  /// From the joint's axis towards the mass centre: q - q_peak above the level. Unit vector.
  [[nodiscard]] Eigen::Vector3d towards_mass(double q_rad) const;
  /// Mass centre of the driven links, r from the axis.
  [[nodiscard]] Eigen::Vector3d mass_centre_m(double q_rad) const;
  /// Place of the surrogate mass, r_REPL from the axis in the same direction.
  [[nodiscard]] Eigen::Vector3d surrogate_centre_m(double q_rad) const;
  /// m r / r_REPL: same torque at every angle.
  [[nodiscard]] double surrogate_mass_kg() const;
  /// Torque about the axis that holds the mass, from the lever and the weight in space [N·m].
  [[nodiscard]] double holding_torque_Nm(double q_rad) const;

 private:
  SerialArm arm_;
  Setting setting_;
};

}  // namespace tribolog
