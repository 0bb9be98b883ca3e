// A whole robot's manifest: each joint's part of it is what a single joint's manifest would be.

#include "ingest/manifest/robot_joints.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/manifest/manifest_file.h"

namespace tribolog::robot_joints_test {
namespace {

using Names = std::vector<std::string>;

const std::string robot_text = R"(schema = "tribolog-dataset-1"
[robot]
name = "six axes"
serial = "17"
[effort]
kind = "motor_current"
side = "motor"
[columns]
time = { name = "t", unit = "s" }
[[recording]]
role = "rough_sweep"
file = "all.csv"
to_s = 60
[[joints]]
name = "J1"
gear_ratio = 100
[joints.effort]
torque_constant_Nm_A = 0.2
[joints.columns]
angle = { name = "q1", unit = "rad" }
effort = { name = "i1", unit = "A" }
[[joints]]
name = "J2"
gear_ratio = 50
gravity = "none"
[joints.effort]
kind = "joint_torque"
side = "joint"
[joints.columns]
angle = { name = "q2", unit = "deg" }
effort = { name = "m2", unit = "Nm" }
[[joints.recording]]
role = "oscillation"
file = "all.csv"
from_s = 60
)";

ingest::manifest::ManifestFile of(const std::string& joint) {
  return ingest::manifest::parse_manifest(robot_text, "robot.toml", joint);
}

std::string refusal(const std::string& text, const std::string& joint) {
  return test::refusal_of<InputError>(
      [&] { (void)ingest::manifest::parse_manifest(text, "robot.toml", joint); });
}

std::string with(const std::string& piece, const std::string& replacement) {
  std::string text = robot_text;
  return text.replace(text.find(piece), piece.size(), replacement);
}

TEST(RobotJoints, AreNamedInTheirOrder) {
  EXPECT_EQ(ingest::manifest::joints_in_manifest(robot_text, "robot.toml"), (Names{"J1", "J2"}));
}

TEST(RobotJoints, EachHasItsOwnAndWhatAllShare) {
  const ingest::manifest::ManifestFile one = of("J1");
  EXPECT_EQ(one.manifest.robot, "six axes");
  EXPECT_EQ(one.manifest.serial, "17");
  EXPECT_EQ(one.manifest.joint, "J1");
  EXPECT_EQ(one.manifest.drive.gear_ratio(), 100);
  EXPECT_EQ(one.manifest.drive.kind(), joint::EffortKind::motor_current);
  ASSERT_EQ(one.recordings.size(), 1U);
  ASSERT_TRUE(one.recordings[0].columns.time && one.recordings[0].columns.angle);
  EXPECT_EQ(one.recordings[0].columns.time->name, "t");
  EXPECT_EQ(one.recordings[0].columns.angle->name, "q1");
}

TEST(RobotJoints, AJointsKeyWinsAndItsRecordingsAreAdded) {
  const ingest::manifest::ManifestFile two = of("J2");
  EXPECT_EQ(two.manifest.drive.kind(), joint::EffortKind::joint_torque);
  EXPECT_TRUE(two.manifest.known_gravity && two.manifest.known_gravity->amplitude_Nm() == 0);
  ASSERT_EQ(two.recordings.size(), 2U);
  EXPECT_EQ(two.recordings[1].role, joint::Role::oscillation);
  EXPECT_EQ(two.recordings[1].columns.effort ? two.recordings[1].columns.effort->name : "", "m2");
}

TEST(RobotJoints, PlacesAreThoseOfTheRobotsFile) {
  EXPECT_NE(refusal(with("gear_ratio = 50", "gear_ratio = -50"), "J2")
                .find("robot.toml:24:14: key 'joint.gear_ratio'"),
            std::string::npos);
  EXPECT_NE(refusal(with("gear_ratio = 50", "gear_ratoi = 50"), "J2").find("robot.toml:"),
            std::string::npos);
}

TEST(RobotJoints, AJointThatIsNotThereIsToldThoseThatAre) {
  for (const std::string joint : {"J3", ""}) {
    EXPECT_NE(refusal(robot_text, joint).find("'J1', 'J2'"), std::string::npos)
        << refusal(robot_text, joint);
  }
}

TEST(RobotJoints, NamesMustTellThemApart) {
  EXPECT_NE(refusal(with("name = \"J2\"", "name = \"J1\""), "J1").find("two joints have this name"),
            std::string::npos);
  EXPECT_NE(refusal(with("name = \"J2\"\n", ""), "J1").find("a joint has no name"),
            std::string::npos);
}

TEST(RobotJoints, WhatCannotBeMeantIsRefused) {
  EXPECT_NE(refusal(robot_text + "[joint]\nname = \"J\"\n", "J1").find("stands beside [[joints]]"),
            std::string::npos);
  EXPECT_NE(refusal(robot_text + "[joints.robot]\nname = \"other\"\n", "J2")
                .find("a joint has no robot of its own"),
            std::string::npos);
  EXPECT_NE(refusal("schema = \"tribolog-dataset-1\"\njoints = []\n", "J1").find("holds no joints"),
            std::string::npos);
}

}  // namespace
}  // namespace tribolog::robot_joints_test
