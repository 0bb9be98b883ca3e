#include "ingest/manifest/robot_file.h"

#include <algorithm>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"

namespace tribolog::robot_file_test {
namespace {

std::string example_text() {
  std::ifstream in(TRIBOLOG_SOURCE_DIR "/examples/paper/am100ib.toml");
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The refusal of the example with one piece of text put in place of another.
std::string refusal(const std::string& from, const std::string& to) {
  std::string text = example_text();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  try {
    static_cast<void>(ingest::manifest::parse_robot(text, "arm.toml"));
  } catch (const InputError& error) {
    EXPECT_GT(error.where().line, 0) << error.what();
    return error.what();
  }
  return "accepted";
}

void expect_part(const std::string& whole, const std::string& part) {
  EXPECT_NE(whole.find(part), std::string::npos) << whole;
}

TEST(RobotFile, ReadsTheExample) {
  const robot::RobotDescription robot = ingest::manifest::parse_robot(example_text(), "arm.toml");
  const robot::JointUnderTest& test = robot.under_test;
  EXPECT_EQ(test.arm().name(), "FANUC AM100iB");
  ASSERT_EQ(test.arm().size(), 6U);
  EXPECT_EQ(robot.portrait_rad.size(), 6U);
  EXPECT_TRUE(robot.approximate);
  EXPECT_EQ(test.setting().joint, 2U);
  EXPECT_NEAR(robot.range.value().lowest_rad, -80 * std::numbers::pi / 180, 1e-12);
  EXPECT_NEAR(robot.load.value().q_peak_rad(), -22.23187 * std::numbers::pi / 180, 1e-12);
  EXPECT_EQ(robot.surrogate_distance_m, 0.5);
  // Stretched out forwards, the centre of the wrist is about 1.4 m from the first axis.
  const double quarter = std::numbers::pi / 2;
  const robot::ArmPose pose = test.arm().pose({0, quarter, quarter, 0, 0, 0});
  EXPECT_NEAR(pose.frames[4].translation().x(), 0.15 + 0.60 + 0.64, 1e-9);
  EXPECT_NEAR(pose.frames[4].translation().z(), 0.45 + 0.20, 1e-9);
}

TEST(RobotFile, SaysWhereAndWhatIsWrong) {
  expect_part(refusal("axis = [0, -1, 0]", "axis = [0, 0, 0]"), "has no direction");
  expect_part(refusal("axis = [0, -1, 0]", "axis = [0, -1]"),
              "found 2 numbers, expected three numbers for each: x, y, z");
  expect_part(refusal("axis = [0, -1, 0]", "axis = [0, -1, 0, 1, 1, 1]"), "is not one point");
  expect_part(refusal("offset_m = [0, 0, 0.60]", "offset_m = [0, 0, 600]"),
              "found 600, expected at most 100 m to each side; hint: lengths are metres");
  expect_part(refusal("lowest_deg = -165", "lowest_deg = 165"), "is empty");
  expect_part(refusal("portrait_deg = -40", "portrait_deg = -150"), "outside the range of motion");
  expect_part(refusal("radius_m = 0.125", "radius_m = -0.125"), "radius_m");
  expect_part(refusal("radius_m = 0.125", "radus_m = 0.125"), "radus_m");
  expect_part(refusal("name = \"2\"", "name = \"1\""), "given twice");
  expect_part(refusal("joint = \"3\"", "joint = \"7\""), "there is no joint '7'");
  expect_part(refusal("joint = \"3\"", "joint = \"1\""), "must be horizontal");
  expect_part(refusal("lowest_deg = -80", "lowest_deg = -170"),
              "key 'under_test.lowest_deg': not usable, found -170°, expected an angle inside the "
              "range of motion of joint '3', -165° to 150°");
  expect_part(refusal("highest_deg = 60", "highest_deg = -80.5"),
              "found -80.5°, expected more than the lowest, -80°");
  expect_part(refusal("highest_deg = 60", "heighest_deg = 60"), "highest");
  expect_part(refusal("\"approximate\"", "\"aproximate\""), "approximate");
  expect_part(refusal("tribolog-robot-1", "tribolog-robot-9"), "schema");
  expect_part(refusal("distance_m = 0.4 ", "distance_m = 0 "), "distance_m");
}

TEST(RobotFile, NamesFileLineAndColumn) {
  expect_part(refusal("axis = [0, -1, 0]", "axis = [0, -1]"), "arm.toml:");
  std::string text = example_text();
  const std::string key = "portrait_deg = -40";
  text.replace(text.find(key), key.size(), "portrait_deg = -150");
  const auto line =
      std::count(text.begin(), text.begin() + static_cast<long>(text.find("portrait_deg = -150")),
                 '\n') +
      1;
  try {
    static_cast<void>(ingest::manifest::parse_robot(text, "arm.toml"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, line);
  }
}

TEST(RobotFile, PointsAtTheLineOfATiltedAxis) {
  const std::string text = example_text();
  const std::string key = "joint = \"3\"";
  std::string tilted = text;
  tilted.replace(tilted.find(key), key.size(), "joint = \"1\"");
  const auto line =
      std::count(tilted.begin(), tilted.begin() + static_cast<long>(tilted.find("joint = \"1\"")),
                 '\n') +
      1;
  try {
    static_cast<void>(ingest::manifest::parse_robot(tilted, "arm.toml"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, line);
    expect_part(error.what(), "the axis of joint '1' is tilted by 90° in this pose");
  }
}

TEST(RobotFile, NeedsNoNumbersOfTheTest) {
  const robot::RobotDescription robot = ingest::manifest::read_robot(
      std::string(TRIBOLOG_SOURCE_DIR) + "/tests/data/planar_arm.toml");
  EXPECT_FALSE(robot.range.has_value());
  EXPECT_FALSE(robot.load.has_value());
  EXPECT_FALSE(robot.approximate);
  EXPECT_EQ(robot.under_test.joint().name, "shoulder");
}

TEST(RobotFile, HoldsAJointThatCannotStandAtZeroWhereItIsNearest) {
  std::string text = example_text();
  const std::string key = "lowest_deg = -190";
  text.replace(text.find(key), key.size(), "lowest_deg = 30");
  const robot::RobotDescription robot = ingest::manifest::parse_robot(text, "arm.toml");
  EXPECT_NEAR(robot.under_test.setting().held_rad[3], std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(robot.portrait_rad[3], std::numbers::pi / 6, 1e-12);
}

TEST(RobotFile, MakesHostileNamesPrintableInItsRefusals) {
  const std::string said = refusal("name = \"3\"", "name = \"\\u001b[31m\\n<b>\"");
  expect_part(said, "there is no joint '3'; the arm has '1', '2', '\\x1b[31m\\x0a<b>'");
}

}  // namespace
}  // namespace tribolog::robot_file_test
