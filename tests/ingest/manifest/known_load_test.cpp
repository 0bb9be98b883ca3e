// Loads stated in the manifest are subtracted from what the logs hold.

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"

namespace tribolog::known_load_test {
namespace {

using test::TemporaryDirectory;

constexpr double gear_ratio = 100;

/// Torque at the joint of 7 + 1.825 sin(q1 + q2), both angles travelling.
std::string log(const std::string& second_angle) {
  std::string csv = "t,q," + second_angle + ",tau\n";
  for (int i = 0; i < 50; ++i) {
    const double q1 = 0.05 * i;
    const double q2 = 0.3 - 0.02 * i;
    csv += fmt::format("{},{},{},{}\n", i / 100.0, q1, q2, 7 + 1.825 * std::sin(q1 + q2));
  }
  return csv;
}

std::string manifest(const std::string& load, const std::string& role = "constant_speed") {
  return "schema = \"tribolog-dataset-1\"\n[robot]\nname = \"R\"\n[joint]\nname = \"J\"\n"
         "gear_ratio = 100\n[effort]\nkind = \"joint_torque\"\nside = \"joint\"\n" +
         load +
         "[columns]\ntime = {name = \"t\", unit = \"s\"}\nangle = {name = \"q\", unit = "
         "\"rad\"}\neffort = {name = \"tau\", unit = \"Nm\"}\n[[recording]]\nrole = \"" +
         role + "\"\nfile = \"a.csv\"\n";
}

const std::string second_link =
    "[[known_load]]\namplitude_Nm = 1.825\nangles = [\"q\", \"q2\"]\nphase_deg = -90\n";

TEST(KnownLoad, LeavesWhatItDoesNotHold) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log("q2"));
  const joint::Dataset d =
      ingest::dataset::read_dataset(directory.file("d.toml", manifest(second_link)));
  for (const double torque : d.recordings.at(0).torque_Nm)
    EXPECT_NEAR(torque, 7 / gear_ratio, 1e-7);
  ASSERT_EQ(d.manifest.known_loads.size(), 1U);
  EXPECT_EQ(d.manifest.known_loads[0].samples, 50U);
  EXPECT_NEAR(d.manifest.known_loads[0].largest_Nm, 1.825, 2e-3);
}

TEST(KnownLoad, UnknownColumnIsRefusedWithItsPlace) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log("theta"));
  const std::string path = directory.file("d.toml", manifest(second_link));
  const std::string message =
      test::refusal_of<InputError>([&] { return ingest::dataset::read_dataset(path); });
  EXPECT_EQ(message.find(directory.path("a.csv") + ":1"), 0U) << message;
  EXPECT_NE(message.find("'q2'"), std::string::npos) << message;
  EXPECT_NE(message.find("d.toml:10"), std::string::npos) << message;
  EXPECT_NE(message.find("roles"), std::string::npos) << message;
}

TEST(KnownLoad, OtherRolesAreLeftAlone) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log("theta"));
  const std::string path = directory.file(
      "d.toml", manifest(second_link + "roles = [\"constant_speed\"]\n", "oscillation"));
  const joint::Dataset d = ingest::dataset::read_dataset(path);
  EXPECT_NEAR(d.recordings.at(0).torque_Nm[0], (7 + 1.825 * std::sin(0.3)) / gear_ratio, 1e-7);
  EXPECT_EQ(d.manifest.known_loads[0].samples, 0U);
}

TEST(KnownLoad, ImpossibleOnesAreRefusedAtTheirPlace) {
  const auto refusal = [](const std::string& load) {
    const test::TemporaryDirectory directory;
    (void)directory.file("a.csv", log("q2"));
    const std::string path = directory.file("d.toml", manifest(load));
    return test::refusal_of<InputError>([&] { return ingest::dataset::read_dataset(path); });
  };
  const std::string head = "[[known_load]]\namplitude_Nm = 1.8\n";
  EXPECT_NE(refusal("[[known_load]]\namplitude_Nm = 0\nangles = [\"q\"]\n").find(":11:"),
            std::string::npos);
  EXPECT_NE(refusal(head).find("angles"), std::string::npos);
  EXPECT_NE(refusal(head + "angles = []\n").find("is empty"), std::string::npos);
  EXPECT_NE(refusal(head + "angles = [3]\n").find("a text"), std::string::npos);
  EXPECT_NE(refusal(head + "angles = [\"q\", \"q\"]\n").find("twice"), std::string::npos);
  EXPECT_NE(refusal(head + "angles = [\"q\"]\nunit = \"Nm\"\n").find("unit"), std::string::npos);
  EXPECT_NE(refusal(head + "angles = [\"q\"]\nroles = [\"sweeep\"]\n").find("no such role"),
            std::string::npos);
  EXPECT_NE(refusal(head + "angles = [\"q\"]\nphase = 3\n").find("phase_deg"), std::string::npos);
}

TEST(StatedGravity, IsReadAndRefused) {
  const test::TemporaryDirectory directory;
  (void)directory.file("a.csv", log("q2"));
  const auto with = [&](const std::string& lines) {
    return directory.file("d.toml", manifest("[known_gravity]\n" + lines));
  };
  const joint::Dataset d =
      ingest::dataset::read_dataset(with("amplitude_Nm = 38.465\nq_peak_deg = 90\n"));
  ASSERT_TRUE(d.manifest.known_gravity);
  EXPECT_EQ(d.manifest.known_gravity->amplitude_Nm(), 38.465);
  EXPECT_NEAR(d.manifest.known_gravity->q_peak_rad(), std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(d.manifest.known_gravity->percent(), 10);
  const joint::Dataset known = ingest::dataset::read_dataset(
      with("amplitude_Nm = 38.465\nq_peak_deg = 90\npercent = 2.5\n"));
  EXPECT_EQ(known.manifest.known_gravity->percent(), 2.5);
  for (const char* percent : {"-1", "51", "nan", "\"10\""}) {
    const std::string path =
        with(fmt::format("amplitude_Nm = 38\nq_peak_deg = 90\npercent = {}\n", percent));
    EXPECT_THROW((void)ingest::dataset::read_dataset(path), InputError) << percent;
  }
  EXPECT_THROW((void)joint::StatedGravity(1, 1, -1), std::invalid_argument);
  EXPECT_THROW((void)joint::StatedGravity(1, 1, NAN), std::invalid_argument);
  const std::string negative = with("amplitude_Nm = -1\nq_peak_deg = 90\n");
  EXPECT_THROW((void)ingest::dataset::read_dataset(negative), InputError);
  EXPECT_THROW((void)joint::StatedGravity(1, NAN), std::invalid_argument);
  EXPECT_NO_THROW((void)joint::StatedGravity(0, 1));  // a balanced joint
  EXPECT_THROW((void)joint::StatedGravity(-1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::known_load_test
