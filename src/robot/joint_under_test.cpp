#include "robot/joint_under_test.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/statement.h"
#include "joint/degrees.h"

namespace tribolog::robot {

namespace {

constexpr double largest_tilt_rad = 1e-6;   // of an axis that is horizontal but for rounding
constexpr double shortest_line_m = 1e-9;    // of a flange that is on the axis but for rounding
constexpr double on_the_axis_share = 1e-6;  // of a frame's axis that is the joint's but for it

/// The link's own line in its frame; nothing where the flange lies on the joint's axis.
Eigen::Vector3d line_in_frame(const SerialArm& arm, std::size_t joint) {
  Eigen::Vector3d flange = arm.tool_m();
  for (std::size_t i = joint + 1; i < arm.size(); ++i) flange += arm.joints()[i].offset_m;
  const Eigen::Vector3d& axis = arm.joints()[joint].axis;
  double farthest_m = shortest_line_m;
  Eigen::Vector3d line = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d way = Eigen::Vector3d::Unit(i) - axis(i) * axis;
    if (way.norm() < on_the_axis_share) continue;
    way.normalize();
    const double along_m = way.dot(flange);
    if (std::abs(along_m) <= farthest_m) continue;
    farthest_m = std::abs(along_m);
    line = along_m > 0 ? way : Eigen::Vector3d(-way);
  }
  return line;
}

}  // namespace

JointUnderTest::JointUnderTest(SerialArm arm, Setting setting)
    : arm_(std::move(arm)), setting_(std::move(setting)) {
  if (setting_.joint >= arm_.size()) {
    throw Refusal(
        {"arm.joint_not_there", {{"joint", setting_.joint + 1}, {"joints", arm_.size()}}});
  }
  within_rad_ = std::clamp(0.0, joint().lowest_rad, joint().highest_rad);
  std::vector<double> angles = setting_.held_rad;
  if (setting_.joint < angles.size()) angles[setting_.joint] = within_rad_;
  const ArmPose held = arm_.pose(angles);
  place_m_ = held.frames[setting_.joint].translation();
  axis_ = arm_.axis(held, setting_.joint);
  const double tilt = std::asin(std::clamp(axis_.z(), -1.0, 1.0));
  if (std::abs(tilt) > largest_tilt_rad) {
    throw Refusal({"arm.axis_not_horizontal",
                   {{"joint", joint().name}, {"tilt_deg", tilt * joint::degrees_per_rad}}});
  }
  const Eigen::Vector3d line =
      pose(0).frames[setting_.joint].linear() * line_in_frame(arm_, setting_.joint);
  if (line.norm() > 0) line_above_level_rad_ = std::atan2(line.z(), line.dot(level()));
}

ArmPose JointUnderTest::pose(double q_rad) const {
  std::vector<double> angles = setting_.held_rad;
  angles[setting_.joint] = within_rad_;
  ArmPose out = arm_.pose(angles);
  const Eigen::Isometry3d turn = Eigen::Translation3d(place_m_) *
                                 Eigen::AngleAxisd(q_rad - within_rad_, axis_) *
                                 Eigen::Translation3d(-place_m_);
  for (std::size_t i = setting_.joint; i < out.frames.size(); ++i) {
    out.frames[i] = turn * out.frames[i];
  }
  out.tool_m = turn * out.tool_m;
  out.tool_frame = turn * out.tool_frame;
  return out;
}

Eigen::Vector3d JointUnderTest::level() const {
  // Turning on from here, about the axis, leads upwards.
  return Eigen::Vector3d::UnitZ().cross(axis_).normalized();
}

Eigen::Vector3d JointUnderTest::above_level(double angle_rad) const {
  return Eigen::AngleAxisd(angle_rad, axis_) * level();
}

Eigen::Vector3d JointUnderTest::towards_mass(double q_rad, double q_peak_rad) const {
  return above_level(q_rad - q_peak_rad);
}

double JointUnderTest::holding_torque_Nm(double q_rad, const joint::GravityLoad& load) const {
  const Eigen::Vector3d lever = load.distance_m() * towards_mass(q_rad, load.q_peak_rad());
  const Eigen::Vector3d weight(0, 0, -load.mass_kg() * load.gravity_m_s2());
  return -lever.cross(weight).dot(axis_);
}

}  // namespace tribolog::robot
