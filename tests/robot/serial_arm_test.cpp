#include "robot/serial_arm.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "wording/words.h"

namespace tribolog::serial_arm_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding_m = 1e-12;  // a dozen products of numbers of size one

robot::ArmJoint joint(const char* name, Eigen::Vector3d axis, Eigen::Vector3d offset_m) {
  robot::ArmJoint out;
  out.name = name;
  out.axis = std::move(axis);
  out.offset_m = std::move(offset_m);
  out.lowest_rad = -pi;
  out.highest_rad = pi;
  return out;
}

/// A post 1 m high, two links of 2 m and 1 m in the plane x-z, positive angles upwards.
robot::SerialArm planar() {
  return {"planar",
          {joint("1", {0, 0, 3}, {0, 0, 1}), joint("2", {0, -1, 0}, {0, 0, 0}),
           joint("3", {0, -1, 0}, {2, 0, 0})},
          {1, 0, 0}};
}

/// Six joints like the example's, with offsets in every direction.
robot::SerialArm six_axes() {
  return {"six",
          {joint("1", {0, 0, 1}, {0, 0, 0.22}), joint("2", {0, 1, 0}, {0.15, 0.02, 0.23}),
           joint("3", {0, -1, 0}, {0, 0, 0.6}), joint("4", {1, 0, 0}, {0.14, -0.03, 0.2}),
           joint("5", {0, -1, 0}, {0.5, 0, 0}), joint("6", {1, 0, 0}, {0.07, 0, 0})},
          {0.04, 0, 0}};
}

std::vector<std::vector<double>> some_poses() {
  std::vector<std::vector<double>> poses{{0, 0, 0, 0, 0, 0}};
  for (int k = 1; k < 40; ++k) {
    std::vector<double> angles;
    for (int i = 0; i < 6; ++i) angles.push_back(3.0 * std::sin(1.7 * k + 2.3 * i));
    poses.push_back(angles);
  }
  return poses;
}

void expect_near(const Eigen::Vector3d& found, const Eigen::Vector3d& wanted) {
  EXPECT_LT((found - wanted).norm(), rounding_m)
      << found.transpose() << " / " << wanted.transpose();
}

TEST(SerialArm, StandsWhereHandWorkedPosesSay) {
  const robot::SerialArm arm = planar();
  expect_near(arm.pose({0, 0, 0}).tool_m, {3, 0, 1});
  expect_near(arm.pose({0, pi / 2, 0}).tool_m, {0, 0, 4});
  expect_near(arm.pose({0, 0, pi / 2}).tool_m, {2, 0, 2});
  expect_near(arm.pose({pi / 2, 0, 0}).tool_m, {0, 3, 1});
  expect_near(arm.pose({pi / 2, pi / 2, -pi / 2}).tool_m, {0, 1, 3});
  const robot::ArmPose pose = arm.pose({0, pi / 6, pi / 6});
  expect_near(pose.frames[2].translation(), {std::sqrt(3.0), 0, 2});
  expect_near(pose.tool_m, {std::sqrt(3.0) + 0.5, 0, 2 + std::sqrt(3.0) / 2});
  expect_near(arm.axis(arm.pose({pi / 2, 1, 0}), 1), {1, 0, 0});
}

// Twists in the base's frame: no joint's own frame enters, unlike in the chain under test.
TEST(SerialArm, AgreesWithTheProductOfExponentials) {
  const robot::SerialArm arm = six_axes();
  for (const auto& angles : some_poses()) {
    Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < arm.size(); ++i) {
      origin += arm.joints()[i].offset_m;
      const Eigen::Vector3d w = arm.joints()[i].axis;
      Eigen::Matrix3d hat;
      hat << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
      const double q = angles[i];
      const Eigen::Matrix3d turn =
          Eigen::Matrix3d::Identity() + std::sin(q) * hat + (1 - std::cos(q)) * hat * hat;
      Eigen::Matrix4d step = Eigen::Matrix4d::Identity();
      step.topLeftCorner<3, 3>() = turn;
      step.topRightCorner<3, 1>() = origin - turn * origin;
      product = product * step;
    }
    const Eigen::Vector4d tool = product * (origin + arm.tool_m()).homogeneous();
    const robot::ArmPose pose = arm.pose(angles);
    expect_near(pose.tool_m, tool.head<3>());
    EXPECT_LT((pose.tool_frame.linear() - product.topLeftCorner<3, 3>()).norm(), 1e-12);
  }
}

TEST(SerialArm, KeepsItsLinksAsLongAsTheyAre) {
  const robot::SerialArm arm = six_axes();
  for (const auto& angles : some_poses()) {
    const robot::ArmPose pose = arm.pose(angles);
    for (std::size_t i = 1; i < arm.size(); ++i) {
      const double length =
          (pose.frames[i].translation() - pose.frames[i - 1].translation()).norm();
      EXPECT_NEAR(length, arm.joints()[i].offset_m.norm(), rounding_m);
      EXPECT_NEAR(pose.frames[i].linear().determinant(), 1.0, 1e-12);
    }
  }
}

TEST(SerialArm, GrowsWithItsLengths) {
  const robot::SerialArm arm = six_axes();
  std::vector<robot::ArmJoint> joints = arm.joints();
  for (robot::ArmJoint& one : joints) one.offset_m *= 2.5;
  const robot::SerialArm larger("larger", joints, 2.5 * arm.tool_m());
  for (const auto& angles : some_poses()) {
    expect_near(larger.pose(angles).tool_m, 2.5 * arm.pose(angles).tool_m);
  }
}

std::string refusal(std::vector<robot::ArmJoint> joints,
                    const Eigen::Vector3d& tool_m = Eigen::Vector3d(0.1, 0, 0)) {
  try {
    const robot::SerialArm arm("arm", std::move(joints), tool_m);
  } catch (const std::invalid_argument& error) {
    return wording::words(error);
  }
  return {};
}

TEST(SerialArm, RefusesWhatNoArmIs) {
  const robot::ArmJoint good = joint("3", {0, 1, 0}, {0, 0, 0});
  EXPECT_EQ(refusal({good}), "");
  EXPECT_EQ(refusal({}), "the arm has no joint");
  EXPECT_EQ(refusal({good}, {0, 0, 0}),
            "all joints and the flange lie at one point; the arm needs a length");
  EXPECT_EQ(refusal({good, good}), "joint '3': the name is given twice");
  robot::ArmJoint bad = good;
  bad.axis = {0, 0, 0};
  EXPECT_EQ(refusal({bad}), "joint '3': the axis [0, 0, 0] has no direction");
  bad = good;
  bad.offset_m.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({bad}), "joint '3': the offset is not finite");
  bad = good;
  bad.lowest_rad = 1;
  bad.highest_rad = -1;
  EXPECT_EQ(refusal({bad}), "joint '3': the range of motion from 57.2958° to −57.2958° is empty");
  bad = good;
  bad.shape.radius_m = 0;
  EXPECT_EQ(refusal({bad}), "joint '3': a size of 0 m is not allowed; it must be > 0");
}

TEST(SerialArm, RefusesAnglesOutsideItsRanges) {
  const robot::SerialArm arm = planar();
  EXPECT_THROW(static_cast<void>(arm.pose({0, 0})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(arm.pose({0, 3.2, 0})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(arm.pose({0, std::nan(""), 0})), std::invalid_argument);
  EXPECT_NO_THROW(static_cast<void>(arm.pose({0, pi, -pi})));
  EXPECT_EQ(arm.index_of("3"), 2U);
  EXPECT_THROW(static_cast<void>(arm.index_of("4")), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::serial_arm_test
