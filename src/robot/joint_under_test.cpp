#include "robot/joint_under_test.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "parameter_rules.h"

namespace tribolog {
namespace {

constexpr double largest_tilt_rad = 1e-6;  // of an axis that is horizontal but for rounding

double degrees(double rad) { return rad * 180 / std::numbers::pi; }

}  // namespace

JointUnderTest::JointUnderTest(SerialArm arm, Setting setting)
    : arm_(std::move(arm)), setting_(std::move(setting)) {
  if (setting_.joint >= arm_.size()) {
    throw std::invalid_argument(
        fmt::format("joint {} is not there; the arm has {}", setting_.joint + 1, arm_.size()));
  }
  const ArmJoint& joint = arm_.joints()[setting_.joint];
  if (!(setting_.lowest_rad < setting_.highest_rad)) {
    throw std::invalid_argument(fmt::format("the range under test from {:.6g}° to {:.6g}° is empty",
                                            degrees(setting_.lowest_rad),
                                            degrees(setting_.highest_rad)));
  }
  require_positive(setting_.surrogate_distance_m, "distance of the surrogate mass", "m");
  static_cast<void>(pose(setting_.lowest_rad));
  static_cast<void>(pose(setting_.highest_rad));
  const double tilt = std::asin(std::clamp(axis().z(), -1.0, 1.0));
  if (std::abs(tilt) > largest_tilt_rad) {
    throw std::invalid_argument(
        fmt::format("the axis of joint '{}' is tilted by {:.3g}° in this "
                    "pose; it must be horizontal",
                    joint.name, degrees(tilt)));
  }
}

ArmPose JointUnderTest::pose(double q_rad) const {
  std::vector<double> angles = setting_.held_rad;
  if (setting_.joint < angles.size()) angles[setting_.joint] = q_rad;
  return arm_.pose(angles);
}

Eigen::Vector3d JointUnderTest::place_m() const {
  return pose(setting_.lowest_rad).frames[setting_.joint].translation();
}

Eigen::Vector3d JointUnderTest::axis() const {
  return arm_.axis(pose(setting_.lowest_rad), setting_.joint);
}

Eigen::Vector3d JointUnderTest::level() const {
  // Turning on from here, about the axis, leads upwards.
  return Eigen::Vector3d::UnitZ().cross(axis()).normalized();
}

Eigen::Vector3d JointUnderTest::towards_mass(double q_rad) const {
  return Eigen::AngleAxisd(q_rad - load().q_peak_rad(), axis()) * level();
}

Eigen::Vector3d JointUnderTest::mass_centre_m(double q_rad) const {
  return place_m() + load().distance_m() * towards_mass(q_rad);
}

Eigen::Vector3d JointUnderTest::surrogate_centre_m(double q_rad) const {
  return place_m() + setting_.surrogate_distance_m * towards_mass(q_rad);
}

double JointUnderTest::surrogate_mass_kg() const {
  return load().mass_kg() * load().distance_m() / setting_.surrogate_distance_m;
}

double JointUnderTest::holding_torque_Nm(double q_rad) const {
  const Eigen::Vector3d lever = mass_centre_m(q_rad) - place_m();
  const Eigen::Vector3d weight(0, 0, -load().mass_kg() * load().gravity_m_s2());
  return -lever.cross(weight).dot(axis());
}

}  // namespace tribolog
