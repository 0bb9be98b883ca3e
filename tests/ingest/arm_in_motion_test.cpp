// Another joint moves while one is recorded: it is counted, and with a description of the arm what
// it changes of gravity is subtracted.

#include "ingest/dataset/arm_in_motion.h"

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "joint/degrees.h"

namespace tribolog::arm_in_motion_test {
namespace {

constexpr double g = 9.80665;
constexpr double gear_ratio = 80;
constexpr double friction_Nm = 4;
constexpr double length_m = 0.7;

// Two links in a plane, angles rising upwards.
const std::string urdf = R"(<robot name="r"><link name="b"/>
  <link name="u"><inertial><origin xyz="0.3 0 0"/><mass value="8"/></inertial></link>
  <link name="f"><inertial><origin xyz="0.25 0 0"/><mass value="5"/></inertial></link>
  <joint name="J1" type="revolute"><parent link="b"/><child link="u"/><axis xyz="0 -1 0"/></joint>
  <joint name="J2" type="revolute"><parent link="u"/><child link="f"/><origin xyz="0.7 0 0"/>
    <axis xyz="0 -1 0"/></joint></robot>)";

double shoulder_Nm(double q1, double q2) {
  return (8 * 0.3 + 5 * length_m) * g * std::cos(q1) + 5 * 0.25 * g * std::cos(q1 + q2);
}

constexpr int samples = 80;
double q1_at(int i) { return -1 + 0.03 * i; }
double q2_at(int i) { return 0.5 + 0.4 * std::sin(0.21 * i); }

double mean_q2() {
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += q2_at(i);
  return sum / samples;
}

/// The torque at the joint, the second joint's angle in degrees and counted the other way.
std::string log(const std::string& second = "q2") {
  std::string csv = "t,q1," + second + ",tau\n";
  for (int i = 0; i < samples; ++i) {
    csv += fmt::format("{},{},{},{}\n", i / 100.0, q1_at(i), -q2_at(i) * joint::degrees_per_rad,
                       shoulder_Nm(q1_at(i), q2_at(i)) + friction_Nm);
  }
  return csv;
}

std::string head(const std::string& robot, const std::string& more = "") {
  return "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n" + robot +
         "[effort]\nkind = \"joint_torque\"\nside = \"joint\"\n" + more;
}

const std::string columns =
    "[columns]\ntime = {name = \"t\", unit = \"s\"}\nangle = {name = \"q1\", unit = \"rad\"}\n"
    "effort = {name = \"tau\", unit = \"Nm\"}\n[[recording]]\nrole = \"rough_sweep\"\nfile = "
    "\"a.csv\"\n";

std::string single(const std::string& robot, const std::string& more = "") {
  return head(robot, "[joint]\nname = \"J1\"\ngear_ratio = 80\n" + more) +
         "[[other_joint]]\nname = \"J2\"\nangle = {name = \"q2\", unit = \"deg\", sign = -1}\n" +
         columns;
}

struct Files {
  test::TemporaryDirectory directory;
  explicit Files(const std::string& csv = log(), const std::string& description = urdf) {
    (void)directory.file("a.csv", csv);
    (void)directory.file("arm.urdf", description);
  }
  [[nodiscard]] joint::Dataset read(const std::string& manifest,
                                    const std::string& joint = "") const {
    return ingest::dataset::read_dataset(directory.file("d.toml", manifest), joint);
  }
};

const std::string described = "description = \"arm.urdf\"\n";

TEST(ArmInMotion, CorrectedTorqueIsThatWithTheOthersHeld) {
  const Files files;
  const joint::Dataset d = files.read(single(described));
  const joint::Recording& r = d.recordings.at(0);
  ASSERT_EQ(r.size(), static_cast<std::size_t>(samples));
  double largest_Nm = 0;
  for (int i = 0; i < samples; ++i) {
    const double held_Nm = shoulder_Nm(q1_at(i), mean_q2()) + friction_Nm;
    EXPECT_NEAR(r.torque_Nm[i] * gear_ratio, held_Nm, 1e-12 * 100);
    const double moved_Nm = shoulder_Nm(q1_at(i), q2_at(i)) + friction_Nm - held_Nm;
    EXPECT_NEAR(r.others_gravity_Nm[i] * gear_ratio, moved_Nm, 1e-12 * 100);
    largest_Nm = std::max(largest_Nm, std::abs(moved_Nm));
  }
  ASSERT_TRUE(d.manifest.arm_gravity);
  const joint::ArmGravity& arm = *d.manifest.arm_gravity;
  EXPECT_NEAR(arm.largest_Nm, largest_Nm, 1e-12 * 100);
  EXPECT_EQ(arm.samples, static_cast<std::size_t>(samples));
  EXPECT_EQ(arm.description_percent, 10);
  EXPECT_EQ(d.manifest.uncertainty.description_percent, 10.0);
  ASSERT_EQ(arm.held.size(), 1U);
  EXPECT_NEAR(arm.held[0].position_rad, mean_q2(), 1e-12);
  // With the other one held, gravity is one cosine: by its phasor.
  const double upper = (8 * 0.3 + 5 * length_m) * g;
  const double fore = 5 * 0.25 * g;
  EXPECT_NEAR(arm.own->amplitude_Nm(),
              std::hypot(upper + fore * std::cos(mean_q2()), fore * std::sin(mean_q2())),
              1e-12 * 100);
  EXPECT_NEAR(arm.own->q_peak_rad(),
              -std::atan2(fore * std::sin(mean_q2()), upper + fore * std::cos(mean_q2())), 1e-12);
  EXPECT_EQ(d.inputs.at(1).name, "arm.urdf");
  EXPECT_EQ(d.inputs.at(1).role, "robot");
}

TEST(ArmInMotion, WithoutDescriptionTheMotionIsCountedAlone) {
  const Files files;
  const joint::Dataset d = files.read(single(""));
  for (int i = 0; i < samples; ++i) {
    EXPECT_NEAR(d.recordings[0].torque_Nm[i] * gear_ratio,
                shoulder_Nm(q1_at(i), q2_at(i)) + friction_Nm, 1e-12 * 100);
  }
  EXPECT_TRUE(d.recordings[0].others_gravity_Nm.empty());
  ASSERT_EQ(d.manifest.other_joints.size(), 1U);
  EXPECT_EQ(d.manifest.other_joints[0].samples, static_cast<std::size_t>(samples));
  EXPECT_NEAR(d.manifest.other_joints[0].travel_rad(), 0.8, 0.01);
  EXPECT_NEAR(d.manifest.other_joints[0].highest_rad, 0.9, 0.01);
}

/// Of a robot: J2's column is that of its own table, in revolutions of its motor.
std::string of_robot(const std::string& robot, const std::string& first,
                     const std::string& second) {
  return head(robot,
              "[columns]\ntime = {name = \"t\", unit = \"s\"}\neffort = {name = \"tau\", unit = "
              "\"Nm\"}\n[[recording]]\nrole = \"rough_sweep\"\nfile = \"a.csv\"\n") +
         fmt::format(
             "[[joints]]\nname = \"{}\"\ngear_ratio = 80\n[joints.columns]\nangle = {{name = "
             "\"q1\", unit = \"rad\"}}\n[[joints]]\nname = \"{}\"\ngear_ratio = 50\n"
             "[joints.columns]\nangle = {{name = \"q2\", unit = \"50 deg\", side = \"motor\", sign "
             "= -1}}\n",
             first, second);
}

TEST(ArmInMotion, JointsOfARobotAreMatchedByNameOrByOrder) {
  const Files files;
  for (const auto& [first, second] : {std::pair{"J1", "J2"}, std::pair{"shoulder", "elbow"}}) {
    const joint::Dataset d = files.read(of_robot(described, first, second), first);
    EXPECT_NEAR(d.recordings[0].torque_Nm[7] * gear_ratio,
                shoulder_Nm(q1_at(7), mean_q2()) + friction_Nm, 1e-12 * 100);
    const bool is_by_order = std::string(first) != "J1";
    EXPECT_EQ(d.manifest.arm_gravity->is_by_order, is_by_order);
    EXPECT_EQ(d.notes.size(), is_by_order ? 1U : 0U);
  }
  const std::string message = test::refusal_of<InputError>(
      [&] { return files.read(of_robot(described, "J1", "elbow"), "J1"); });
  EXPECT_NE(message.find("arm.urdf: has no such joint, found 'elbow'"), std::string::npos)
      << message;
}

TEST(ArmInMotion, GapsAndTurnsOfTheOtherLeaveNoRowOut) {
  // From sample 30 on a turn higher; two gaps, of which one is at the end.
  std::string csv = "t,q1,q2,tau\n";
  for (int i = 0; i < samples; ++i) {
    const double logged =
        (-q2_at(i) + (i >= 30 ? 2 * std::numbers::pi : 0)) * joint::degrees_per_rad;
    csv += fmt::format("{},{},{},{}\n", i / 100.0, q1_at(i),
                       i == 40 || i == samples - 1 ? "nan" : fmt::format("{}", logged),
                       shoulder_Nm(q1_at(i), q2_at(i)) + friction_Nm);
  }
  const Files files(csv);
  const joint::Dataset d = files.read(single(described));
  ASSERT_EQ(d.recordings[0].size(), static_cast<std::size_t>(samples));
  EXPECT_LT(d.manifest.other_joints[0].travel_rad(), 0.81);
  EXPECT_NEAR(d.recordings[0].torque_Nm[40] * gear_ratio,
              shoulder_Nm(q1_at(40), mean_q2()) + friction_Nm, 0.1);
  EXPECT_NEAR(d.recordings[0].torque_Nm[50] * gear_ratio,
              shoulder_Nm(q1_at(50), mean_q2()) + friction_Nm, 0.1);
}

TEST(ArmInMotion, WhatNoColumnTellsIsSaid) {
  const Files files(log("other"));
  const joint::Dataset d = files.read(single(described));
  EXPECT_EQ(d.manifest.other_joints[0].samples, 0U);
  EXPECT_EQ(d.manifest.arm_gravity->samples, 0U);
  bool is_said = false;
  for (const Statement& note : d.notes) is_said |= note.is("reading.arm_joints_at_zero");
  EXPECT_TRUE(is_said);
}

TEST(ArmInMotion, JointsOfTheDescriptionAreFoundInTheLogByItsNames) {
  std::string csv = "t,q1,J2.position,tau\n";
  for (int i = 0; i < samples; ++i) {
    csv += fmt::format("{},{},{},{}\n", i / 100.0, q1_at(i), q2_at(i),
                       shoulder_Nm(q1_at(i), q2_at(i)));
  }
  const Files files(csv);
  const joint::Dataset d =
      files.read(head(described, "[joint]\nname = \"J1\"\ngear_ratio = 80\n") + columns);
  EXPECT_NEAR(d.recordings[0].torque_Nm[7] * gear_ratio, shoulder_Nm(q1_at(7), mean_q2()),
              1e-12 * 100);
  EXPECT_TRUE(d.notes.empty());
}

TEST(ArmInMotion, KeysOfTheManifestAreCheckedAtTheirPlace) {
  const auto refusal = [](const std::string& manifest) {
    const Files files;
    return test::refusal_of<InputError>([&] { return files.read(manifest); });
  };
  EXPECT_NE(refusal(single("gravity = [0, 0, -9.8]\n")).find("d.toml:4:"), std::string::npos);
  EXPECT_NE(refusal(single(described + "gravity = [0, 0, -1.6]\n")).find("1.6 m/s²"),
            std::string::npos);
  EXPECT_NE(refusal(single(described + "gravity = [0, -9.8]\n")).find("2 numbers"),
            std::string::npos);
  EXPECT_NE(refusal(single("", "[uncertainty]\ndescription_percent = 5\n")).find("masses"),
            std::string::npos);
  EXPECT_NE(refusal(single(described, "[uncertainty]\ndescription_percent = 60\n"))
                .find("half of the number"),
            std::string::npos);
  EXPECT_NE(
      refusal(single("[[other_joint]]\nname = \"J2\"\nangle = {name = \"a\", unit = \"rad\"}\n"))
          .find("is given twice"),
      std::string::npos);
  EXPECT_NE(refusal(single("", "[[other_joint]]\nname = \"J3\"\n")).find("angle = { name"),
            std::string::npos);
  const Files files;
  const joint::Dataset d = files.read(
      single(described + "gravity = [0, 9.81, 0]\n", "[uncertainty]\ndescription_percent = 5\n"));
  EXPECT_EQ(d.manifest.arm_gravity->description_percent, 5);
  // Along the axis gravity does nothing.
  EXPECT_NEAR(d.manifest.arm_gravity->largest_Nm, 0, 1e-12);
}

}  // namespace
}  // namespace tribolog::arm_in_motion_test
