#include "robot/joint_under_test.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "ingest/manifest/robot_file.h"
#include "joint/gravity_load.h"

namespace tribolog::joint_under_test_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-12;  // a dozen products of numbers of size one

robot::RobotDescription example() {
  return ingest::manifest::read_robot(TRIBOLOG_SOURCE_DIR "/examples/paper/am100ib.toml");
}

/// Links of 0.5 m and 0.35 m on a post, upright at 0, turning about x.
robot::JointUnderTest planar_arm() {
  return ingest::manifest::read_robot(TRIBOLOG_SOURCE_DIR "/tests/data/planar_arm.toml").under_test;
}

constexpr double angles[] = {-1.3, -0.4, 0.2, 1.0};

// The lever and the weight in space against m g r cos(q - q_peak).
TEST(JointUnderTest, PutsTheMassWhereItAsksTheTorqueOfItsGravityLoad) {
  for (const robot::JointUnderTest& test : {example().under_test, planar_arm()}) {
    const joint::GravityLoad load(30, 0.4, -0.388);
    for (const double q : angles) {
      EXPECT_NEAR(test.holding_torque_Nm(q, load), load.torque_Nm(q), 1e-9);
    }
    EXPECT_NEAR(test.towards_mass(load.q_peak_rad(), load.q_peak_rad()).z(), 0.0, rounding);
  }
}

TEST(JointUnderTest, KeepsTheMassCentreInItsLink) {
  for (const robot::JointUnderTest& test : {example().under_test, planar_arm()}) {
    const auto in_link = [&](double q) -> Eigen::Vector3d {
      return test.pose(q).frames[test.setting().joint].linear().transpose() *
             test.towards_mass(q, 0.3);
    };
    for (const double q : angles) EXPECT_LT((in_link(q) - in_link(0)).norm(), rounding);
  }
}

TEST(JointUnderTest, FindsTheLineFromWhichTheLinkCounts) {
  const robot::JointUnderTest paper = example().under_test;
  EXPECT_NEAR(paper.line_above_level_rad(), 0.0, rounding) << "the forearm is level at 0";
  EXPECT_NEAR(paper.level().x(), 1.0, rounding) << "in front of the joint";
  // Upright at 0; a positive turn about x leads from y upwards, so that y is the level.
  const robot::JointUnderTest planar = planar_arm();
  EXPECT_NEAR(planar.line_above_level_rad(), pi / 2, rounding);
  EXPECT_NEAR(planar.level().y(), 1.0, rounding);
  for (const double q : angles) {
    const Eigen::Vector3d flange = planar.pose(q).tool_m - planar.place_m();
    const Eigen::Vector3d line = planar.above_level(planar.line_above_level_rad() + q);
    EXPECT_LT((flange - 0.85 * line).norm(), rounding);
  }
}

// The second joint of the example carries the third: held elsewhere, the forearm is so at 0 too.
TEST(JointUnderTest, TurnsTheLineWithTheJointsBefore) {
  robot::JointUnderTest::Setting setting = example().under_test.setting();
  setting.held_rad[1] = 0.3;  // forwards, down
  const robot::JointUnderTest leaning(example().under_test.arm(), setting);
  EXPECT_NEAR(leaning.line_above_level_rad(), -0.3, rounding);
}

TEST(JointUnderTest, HasALevelLineWhereTheFlangeIsOnItsAxis) {
  robot::ArmJoint joint;
  joint.name = "spin";
  joint.axis = {0, -1, 0};
  joint.lowest_rad = -1;
  joint.highest_rad = 1;
  const robot::JointUnderTest test(robot::SerialArm("one", {joint}, {0, 0.2, 0}), {0, {0.0}});
  EXPECT_EQ(test.line_above_level_rad(), 0.0);
}

TEST(JointUnderTest, TurnsBeyondItsRangeLikeWithinIt) {
  const robot::JointUnderTest test = planar_arm();
  const double highest = test.joint().highest_rad;
  const robot::ArmPose within = test.pose(highest);
  const robot::ArmPose chain = test.arm().pose({highest, 0});
  EXPECT_LT((within.tool_m - chain.tool_m).norm(), rounding);
  EXPECT_LT((within.frames[1].matrix() - chain.frames[1].matrix()).norm(), rounding);
  const robot::ArmPose beyond = test.pose(highest + 0.5);
  const Eigen::Vector3d before = within.tool_m - test.place_m();
  const Eigen::Vector3d after = beyond.tool_m - test.place_m();
  EXPECT_NEAR(before.dot(after), 0.85 * 0.85 * std::cos(0.5), rounding);
}

TEST(JointUnderTest, RefusesATiltedAxisAndAMissingJoint) {
  const robot::SerialArm arm = example().under_test.arm();
  const robot::JointUnderTest::Setting good = example().under_test.setting();
  for (const std::size_t joint : {0U, 6U}) {
    robot::JointUnderTest::Setting bad = good;
    bad.joint = joint;
    EXPECT_THROW(robot::JointUnderTest(arm, bad), std::invalid_argument) << joint;
  }
  robot::JointUnderTest::Setting bad = good;
  bad.held_rad.pop_back();
  EXPECT_THROW(robot::JointUnderTest(arm, bad), std::invalid_argument);
  bad = good;
  bad.held_rad[0] = 2 * pi;
  EXPECT_THROW(robot::JointUnderTest(arm, bad), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::joint_under_test_test
