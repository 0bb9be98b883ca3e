#include "robot/weighted_arm.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "robot/serial_arm.h"

namespace tribolog::weighted_arm_test {
namespace {

constexpr double g = 9.80665;
const Eigen::Vector3d gravity(0, 0, -g);

robot::WeightedJoint weighted(const char* name, Eigen::Vector3d axis, Eigen::Vector3d offset_m,
                              double mass_kg, Eigen::Vector3d centre_m) {
  robot::WeightedJoint joint;
  joint.name = name;
  joint.axis = std::move(axis);
  joint.at_zero = Eigen::Translation3d(offset_m);
  joint.mass_kg = mass_kg;
  joint.centre_m = std::move(centre_m);
  return joint;
}

TEST(WeightedArm, HoldsTwoLinksInAPlaneAsInClosedForm) {
  constexpr double length_m = 0.7;
  auto first = weighted("1", {0, -2, 0}, {0.1, 0.2, 1}, 8, {0.3, 0, 0});
  auto second = weighted("2", {0, -1, 0}, {length_m, 0.05, 0}, 5, {0.25, 0.1, 0});
  second.parent = 0;
  const robot::WeightedArm arm({first, second});
  for (int k = 0; k < 25; ++k) {
    const double q1 = 0.37 * k - 4;
    const double q2 = 3 * std::sin(1.3 * k);
    const double second_Nm = 5 * g * 0.25 * std::cos(q1 + q2);
    const double first_Nm = (8 * 0.3 + 5 * length_m) * g * std::cos(q1) + second_Nm;
    EXPECT_NEAR(arm.holding_torque_Nm(0, {q1, q2}, gravity), first_Nm, 1e-12 * 100);
    EXPECT_NEAR(arm.holding_torque_Nm(1, {q1, q2}, gravity), second_Nm, 1e-12 * 100);
  }
}

TEST(WeightedArm, HoldingTorqueIsTheSlopeOfTheEnergyOfASerialArm) {
  const Eigen::Vector3d axes[] = {{0, 0, 1}, {0, 1, 0},  {0, -1, 0},
                                  {1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
  const Eigen::Vector3d offsets_m[] = {{0, 0, 0.22},       {0.15, 0.02, 0.23}, {0, 0, 0.6},
                                       {0.14, -0.03, 0.2}, {0.5, 0, 0},        {0.07, 0, 0}};
  const Eigen::Vector3d pull(1.5, -2, -9.5);  // the base is tilted
  std::vector<robot::ArmJoint> chain(6);
  std::vector<robot::WeightedJoint> joints;
  for (std::size_t i = 0; i < 6; ++i) {
    chain[i].name = std::to_string(i);
    chain[i].axis = axes[i];
    chain[i].offset_m = offsets_m[i];
    chain[i].lowest_rad = -10;
    chain[i].highest_rad = 10;
    joints.push_back(weighted("", axes[i], offsets_m[i], 12.0 - 2.0 * static_cast<double>(i),
                              {0.1, 0.02 * static_cast<double>(i), 0.05}));
    if (i > 0) joints.back().parent = i - 1;
  }
  const robot::SerialArm serial("six", chain, {0.04, 0, 0});
  const robot::WeightedArm arm(joints);
  const auto energy_J = [&](const std::vector<double>& angles) {
    const robot::ArmPose pose = serial.pose(angles);
    double sum = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      sum -= joints[i].mass_kg * pull.dot(pose.frames[i] * joints[i].centre_m);
    }
    return sum;
  };
  for (int k = 0; k < 10; ++k) {
    std::vector<double> angles;
    for (int i = 0; i < 6; ++i) angles.push_back(3.0 * std::sin(1.7 * k + 2.3 * i));
    for (std::size_t i = 0; i < 6; ++i) {
      constexpr double step = 1e-5;
      std::vector<double> above = angles;
      std::vector<double> below = angles;
      above[i] += step;
      below[i] -= step;
      EXPECT_NEAR(arm.holding_torque_Nm(i, angles, pull),
                  (energy_J(above) - energy_J(below)) / (2 * step), 1e-6);
    }
  }
}

TEST(WeightedArm, GravityWithTheOthersHeldIsOneCosine) {
  auto first = weighted("1", {0.1, -1, 0.4}, {0, 0, 1}, 8, {0.3, 0.1, -0.1});
  auto second = weighted("2", {1, -1, 0}, {0.6, 0.05, 0}, 5, {0.25, 0.1, 0});
  second.parent = 0;
  const robot::WeightedArm arm({first, second});
  const joint::StatedGravity own = arm.gravity_of(0, {0, 0.8}, gravity);
  for (double q = -3; q < 3; q += 0.5) {
    EXPECT_NEAR(arm.holding_torque_Nm(0, {q, 0.8}, gravity),
                own.amplitude_Nm() * std::cos(q - own.q_peak_rad()), 1e-12 * 100);
  }
}

TEST(WeightedArm, SlidingAndFollowingJointsMoveTheirMasses) {
  auto first = weighted("1", {0, -1, 0}, {0, 0, 0}, 0, {0, 0, 0});
  auto slide = weighted("2", {1, 0, 0}, {0.2, 0, 0}, 4, {0, 0, 0});
  slide.parent = 0;
  slide.motion = robot::JointMotion::sliding;
  auto follower = slide;
  follower.name = "3";
  follower.follows = robot::FollowedJoint{1, -0.5, 0.1};
  const robot::WeightedArm arm({first, slide, follower});
  // At 0.2 + 0.3 and at 0.2 - 0.15 + 0.1.
  EXPECT_NEAR(arm.holding_torque_Nm(0, {0, 0.3, 77}, gravity), 4 * g * (0.5 + 0.15), 1e-12 * 100);
  // Upright, the slide carries its own weight alone.
  EXPECT_NEAR(arm.holding_torque_Nm(1, {std::numbers::pi / 2, 0.3, 77}, gravity), 4 * g,
              1e-12 * 100);
}

TEST(WeightedArm, WhatIsImpossibleIsRefused) {
  const auto joint = weighted("1", {0, 1, 0}, {0, 0, 0}, 1, {0, 0, 0});
  auto before_parent = joint;
  before_parent.parent = 0;
  auto no_axis = joint;
  no_axis.axis = {0, 0, 0};
  auto negative = joint;
  negative.mass_kg = -1;
  EXPECT_THROW(robot::WeightedArm({}), std::invalid_argument);
  for (const robot::WeightedJoint& wrong : {before_parent, no_axis, negative}) {
    EXPECT_THROW(robot::WeightedArm({wrong}), std::invalid_argument);
  }
}

}  // namespace
}  // namespace tribolog::weighted_arm_test
