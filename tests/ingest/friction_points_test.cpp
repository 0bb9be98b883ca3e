// A table of friction over speed, read as points of the curve.

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "wording/words.h"

namespace tribolog::friction_points_test {
namespace {

const std::string head = R"(schema = "tribolog-dataset-1"
[robot]
name = "R"
[joint]
name = "J"
gear_ratio = 50
[effort]
kind = "joint_torque"
side = "joint"
)";

const std::string points = R"([[recording]]
role = "friction_points"
file = "points.csv"
)";

const std::string columns = R"([recording.columns]
speed = {name = "v", unit = "deg/s"}
effort = {name = "tau", unit = "Nm"}
load = {name = "load", unit = "Nm"}
)";

joint::Dataset read(const std::string& manifest, const std::string& csv) {
  const test::TemporaryDirectory directory;
  (void)directory.file("points.csv", csv);
  return ingest::dataset::read_dataset(directory.file("dataset.toml", manifest));
}

std::string refusal(const std::string& manifest, const std::string& csv) {
  return test::refusal_of<InputError>([&] { (void)read(manifest, csv); });
}

const std::string table = "v,tau,load\n90,10,0\n-90,-11,20\n0,0,5\n45,,5\n180,12,40\n";

TEST(FrictionPoints, AreReadAtTheMotorAndEachRowLeftOutIsCounted) {
  const joint::Dataset d = read(head + points + columns, table);
  ASSERT_EQ(d.friction_points.size(), 1U);
  EXPECT_TRUE(d.recordings.empty());
  const joint::FrictionPoints& p = d.friction_points.front();
  ASSERT_EQ(p.size(), 3U);
  EXPECT_NEAR(p.speed_rad_s[1], -50 * 1.5707963267948966, 1e-12);
  EXPECT_NEAR(p.torque_Nm[1], -11.0 / 50, 1e-15);
  EXPECT_NEAR(p.load_Nm[1], 20.0 / 50, 1e-15);
  EXPECT_EQ(p.rows_read, 5U);
  ASSERT_EQ(p.skipped.size(), 2U);
  EXPECT_EQ(p.skipped[0].count + p.skipped[1].count, 2U);
  EXPECT_EQ(d.inputs.at(1).role, "friction_points");
  EXPECT_EQ(d.inputs.at(1).rows_used, 3U);
  // Nothing but friction is in them.
  ASSERT_TRUE(d.manifest.known_gravity);
  EXPECT_EQ(d.manifest.known_gravity->amplitude_Nm(), 0);
}

TEST(FrictionPoints, SingleNumbersThatNoJointHasAreLeftOutWhereTheManifestAllows) {
  std::string csv = "v,tau,load\n";
  for (int i = 1; i <= 200; ++i) {
    csv += std::to_string(i) + "," + (i == 50 ? "1e300" : std::to_string(10 + i)) + ",0\n";
  }
  EXPECT_NE(refusal(head + points + columns, csv).find("skip_bad_rows = true leaves it out"),
            std::string::npos);
  const joint::Dataset d = read(head + "[log]\nskip_bad_rows = true\n" + points + columns, csv);
  const joint::FrictionPoints& p = d.friction_points.front();
  EXPECT_EQ(p.size(), 199U);
  ASSERT_EQ(p.skipped.size(), 1U);
  EXPECT_TRUE(p.skipped[0].reason.is("skipped.impossible"));
  EXPECT_EQ(p.skipped[0].count, 1U);
}

// A law of friction is a matter of some hundred speeds: a million rows give means of neighbours.
TEST(FrictionPoints, ManyAreAveragedWithTheirNeighboursInSpeed) {
  std::string csv = "v,tau,load\n";
  const int rows = 9000;
  for (int i = 1; i <= rows; ++i) {
    const int k = (i * 7919) % rows + 1;  // in no order
    const bool is_back = k % 3 == 0;
    csv += fmt::format("{},{},1\n", is_back ? -k : k, (is_back ? -10 : 10) + k * 0.001);
  }
  const joint::Dataset d = read(head + points + columns, csv);
  const joint::FrictionPoints& p = d.friction_points.front();
  ASSERT_LE(p.size(), 2000U);
  ASSERT_GE(p.size(), 1900U);
  EXPECT_EQ(p.load_Nm.size(), p.size());
  const double rad_s = 50 * std::numbers::pi / 180;  // at the motor, of a degree per second
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double v = p.speed_rad_s[i] / rad_s;
    const double law = (v < 0 ? -10 : 10) + std::abs(v) * 0.001;
    EXPECT_NEAR(50 * p.torque_Nm[i], law, 1e-9) << "no mean is over both directions";
  }
  EXPECT_EQ(d.inputs.at(1).rows_used, static_cast<std::size_t>(rows)) << "each row counts";
  ASSERT_FALSE(d.notes.empty());
  EXPECT_NE(wording::words(d.notes.back()).find("are averaged to"), std::string::npos);
}

TEST(FrictionPoints, WithoutSpeedTimeOrSignAreRefused) {
  EXPECT_NE(
      refusal(head + points + "[recording.columns]\neffort = {name = \"tau\", unit = \"Nm\"}\n",
              table)
          .find("no column is stated for the speed"),
      std::string::npos);
  EXPECT_NE(refusal(head + points + "from_s = 3\n" + columns, table).find("they have no time"),
            std::string::npos);
  const std::string amounts = "v,tau,load\n90,10,0\n-90,11,20\n-45,9,5\n180,12,40\n";
  EXPECT_NE(refusal(head + points + columns, amounts).find("at 2 of 2 points of negative speed"),
            std::string::npos);
  EXPECT_NE(refusal(head + points + columns, "v,tau,load\n90,10,0\n0,11,20\n")
                .find("too few friction points"),
            std::string::npos);
  EXPECT_NE(refusal(head + points + columns, "v,tau,load\n90,10,0\n91,1e9,0\n92,10,0\n")
                .find("points.csv:3"),
            std::string::npos);
}

/// What [columns] says of time and angle is of the recordings beside them.
TEST(FrictionPoints, StandBesideRecordings) {
  std::string log = "t,q,tau\n";
  for (int i = 0; i < 40; ++i) {
    log += std::to_string(0.01 * i) + "," + std::to_string(0.01 * i) + ",3\n";
  }
  const test::TemporaryDirectory directory;
  (void)directory.file("points.csv", table);
  (void)directory.file("sweep.csv", log);
  const std::string common =
      "[columns]\ntime = {name = \"t\", unit = \"s\"}\nangle = {name = \"q\", unit = \"rad\"}\n"
      "effort = {name = \"tau\", unit = \"Nm\"}\n";
  const std::string sweep = "[[recording]]\nrole = \"rough_sweep\"\nfile = \"sweep.csv\"\n";
  const joint::Dataset d = ingest::dataset::read_dataset(
      directory.file("dataset.toml", head + common + sweep + points + columns));
  EXPECT_EQ(d.recordings.size(), 1U);
  EXPECT_EQ(d.friction_points.size(), 1U);
  EXPECT_FALSE(d.manifest.known_gravity);
  EXPECT_NE(test::refusal_of<InputError>([&] {
              (void)ingest::dataset::read_dataset(directory.file(
                  "wrong.toml",
                  head + common + sweep + "columns = {load = {name = \"tau\", unit = \"Nm\"}}\n"));
            }).find("for friction points alone"),
            std::string::npos);
}

}  // namespace
}  // namespace tribolog::friction_points_test
