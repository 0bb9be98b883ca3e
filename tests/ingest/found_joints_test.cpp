// Angles of other joints are found in a log by its own names, without a word in the manifest.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "joint/degrees.h"

namespace tribolog::found_joints_test {
namespace {

constexpr int samples = 120;
double q2_at(int i) { return 1 + 0.4 * std::sin(0.2 * i); }

std::string manifest(const std::string& file, const std::string& columns,
                     const std::string& more = "") {
  return "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n[joint]\nname = \"J1\"\n"
         "gear_ratio = 1\n[effort]\nkind = \"joint_torque\"\nside = \"joint\"\n" +
         more + "[columns]\n" + columns + "[[recording]]\nrole = \"rough_sweep\"\nfile = \"" +
         file + "\"\n";
}

joint::Dataset read(const std::string& file, const std::string& log, const std::string& text) {
  const test::TemporaryDirectory directory;
  (void)directory.file(file, log);
  return ingest::dataset::read_dataset(directory.file("d.toml", text));
}

const std::string columns =
    "time = {name = \"t\", unit = \"s\"}\nangle = {name = \"q_1\", unit = \"deg\"}\n"
    "effort = {name = \"tau_1\", unit = \"Nm\"}\n";

void expect_the_second(const joint::Dataset& d) {
  ASSERT_EQ(d.manifest.other_joints.size(), 1U);
  const joint::OtherJoint& other = d.manifest.other_joints.front();
  EXPECT_EQ(other.name, "2");
  EXPECT_EQ(other.samples, static_cast<std::size_t>(samples));
  EXPECT_NEAR(other.travel_rad(), 0.8, 0.01);
  EXPECT_NEAR(other.highest_rad, 1.4, 0.01);
}

std::string wide_log() {
  std::string csv = "t,q_1,q_2,target_q_2,tau_1,tau_2\n";
  for (int i = 0; i < samples; ++i) {
    csv += fmt::format("{},{},{:.6f},9,{},0\n", i / 100.0, 0.2 * i,
                       q2_at(i) * joint::degrees_per_rad, 1 + 0.01 * i);
  }
  return csv;
}

TEST(FoundJoints, InColumnsAreReadInTheUnitOfTheTestedOne) {
  const joint::Dataset d = read("a.csv", wide_log(), manifest("a.csv", columns));
  expect_the_second(d);
  ASSERT_EQ(d.recordings.at(0).size(), static_cast<std::size_t>(samples));
  EXPECT_NEAR(d.recordings[0].q_rad[50], 10 * joint::rad_per_degree, 1e-12);
  EXPECT_NEAR(d.recordings[0].torque_Nm[50], 1.5, 1e-12);
}

TEST(FoundJoints, InAJsonLogAreReadToo) {
  std::string json = "{\"t\": [";
  const auto list = [&](const auto& value) {
    std::string text;
    for (int i = 0; i < samples; ++i) text += fmt::format("{}{:.9g}", i > 0 ? "," : "", value(i));
    return text + "]";
  };
  json += list([](int i) { return i / 100.0; }) + ", \"q_1\": [" +
          list([](int i) { return 0.2 * i; }) + ", \"q_2\": [" +
          list([](int i) { return q2_at(i) * joint::degrees_per_rad; }) + ", \"tau_1\": [" +
          list([](int i) { return 1 + 0.01 * i; }) + "}";
  expect_the_second(read("a.json", json, manifest("a.json", columns)));
}

TEST(FoundJoints, AreThoseOfTheManifestWhereItNamesThem) {
  const joint::Dataset d = read(
      "a.csv", wide_log(),
      manifest("a.csv", columns,
               "[[other_joint]]\nname = \"elbow\"\nangle = {name = \"q_2\", unit = \"deg\"}\n"));
  ASSERT_EQ(d.manifest.other_joints.size(), 1U);
  EXPECT_EQ(d.manifest.other_joints.front().name, "elbow");
}

TEST(FoundJoints, AreNoneWhereTheLogNamesNone) {
  std::string csv = "t,q,tau\n";
  for (int i = 0; i < samples; ++i) csv += fmt::format("{},{},1\n", i / 100.0, 0.2 * i);
  const joint::Dataset d =
      read("a.csv", csv,
           manifest("a.csv",
                    "time = {name = \"t\", unit = \"s\"}\nangle = {name = \"q\", unit = "
                    "\"deg\"}\neffort = {name = \"tau\", unit = \"Nm\"}\n"));
  EXPECT_TRUE(d.manifest.other_joints.empty());
}

/// A row for each joint; those of the second one come a tick later.
TEST(FoundJoints, InRowsOfOneJointEachAreThoseToldLast) {
  std::string csv = "t,joint,q,tau\n";
  for (int i = 0; i < samples; ++i) {
    csv += fmt::format("{},{},{:.6f},0\n", i / 100.0 - 0.002, 2, q2_at(i) * joint::degrees_per_rad);
    csv += fmt::format("{},{},{},{}\n", i / 100.0, 1, 0.2 * i, 1 + 0.01 * i);
  }
  const joint::Dataset d =
      read("a.csv", csv,
           manifest("a.csv",
                    "time = {name = \"t\", unit = \"s\"}\nangle = {name = \"q\", unit = \"deg\"}\n"
                    "effort = {name = \"tau\", unit = \"Nm\"}\n"
                    "rows = {name = \"joint\", value = \"1\"}\n"));
  expect_the_second(d);
  ASSERT_EQ(d.recordings.at(0).size(), static_cast<std::size_t>(samples));
  EXPECT_NEAR(d.recordings[0].q_rad[50], 10 * joint::rad_per_degree, 1e-12);
}

}  // namespace
}  // namespace tribolog::found_joints_test
