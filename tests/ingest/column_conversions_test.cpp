// The factor that the report shows is the one that every row was multiplied by.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "ingest/dataset/recording_rows.h"

namespace tribolog::column_conversions_test {
namespace {

const std::string manifest = R"(schema = "tribolog-dataset-1"
[robot]
name = "R"
[joint]
name = "J"
gear_ratio = 50
[effort]
kind = "motor_current"
side = "joint"
torque_constant_Nm_A = 20
sign = -1
[columns]
time = {name = "timestamp", unit = "ms"}
angle = {name = "actual_q_1", unit = "deg", side = "motor"}
speed = {name = "actual_qd_1", unit = "rpm", side = "motor"}
effort = {name = "actual_current_1", unit = "mA"}
temperature = {name = "joint_temperatures_1", unit = "degC"}
[[recording]]
role = "rough_sweep"
file = "a.csv"
[[recording]]
role = "constant_speed"
file = "b.csv"
columns = {angle = {name = "q", unit = "rad"}}
)";

joint::Dataset read_two_logs() {
  const test::TemporaryDirectory directory;
  for (const char* name : {"a.csv", "b.csv"}) {
    std::string csv =
        name == std::string("a.csv")
            ? "timestamp,actual_q_1,actual_qd_1,actual_current_1,joint_temperatures_1\n"
            : "timestamp,q,actual_qd_1,actual_current_1,joint_temperatures_1\n";
    for (int i = 0; i < 40; ++i) csv += fmt::format("{},{},{},{},{}\n", 8 * i, 90 + i, 30, 250, 31);
    (void)directory.file(name, csv);
  }
  return ingest::dataset::read_dataset(directory.file("dataset.toml", manifest));
}

const joint::ColumnConversion& conversion(const joint::InputFile& input,
                                          joint::LoggedSignal signal) {
  for (const joint::ColumnConversion& one : input.conversions) {
    if (one.signal == signal) return one;
  }
  throw std::logic_error("no such signal");
}

TEST(ColumnConversions, ShownAreTheOnesApplied) {
  const joint::Dataset d = read_two_logs();
  ASSERT_EQ(d.inputs.size(), 3U);
  EXPECT_TRUE(d.inputs[0].conversions.empty()) << "the manifest";
  const joint::InputFile& log = d.inputs[1];
  const joint::Recording& r = d.recordings[0];
  ASSERT_EQ(log.conversions.size(), 5U);
  EXPECT_EQ(r.t_s[7], 56 * conversion(log, joint::LoggedSignal::time).factor());
  EXPECT_EQ(r.q_rad[7], 97 * conversion(log, joint::LoggedSignal::angle).factor());
  EXPECT_EQ(r.dq_rad_s[7], 30 * conversion(log, joint::LoggedSignal::speed).factor());
  EXPECT_EQ(r.torque_Nm[7], 250 * conversion(log, joint::LoggedSignal::effort).factor());
  EXPECT_EQ(r.temperature_C[7], 31);
  // 0.25 A at 20 N·m/A are 5 N·m at the joint, 0.1 N·m at the motor, and the sign turns them round.
  EXPECT_DOUBLE_EQ(r.torque_Nm[7], -0.1);
  EXPECT_EQ(conversion(log, joint::LoggedSignal::effort).steps.size(), 4U);
  EXPECT_EQ(conversion(log, joint::LoggedSignal::effort).side, joint::Side::motor);
  EXPECT_EQ(conversion(log, joint::LoggedSignal::angle).side, joint::Side::joint);
  EXPECT_EQ(conversion(log, joint::LoggedSignal::temperature).side, std::nullopt);
}

TEST(ColumnConversions, AreEachRecordingsOwn) {
  const joint::Dataset d = read_two_logs();
  const joint::ColumnConversion& angle = conversion(d.inputs[2], joint::LoggedSignal::angle);
  EXPECT_EQ(angle.column, "q");
  EXPECT_EQ(angle.factor(), 1.0);
  EXPECT_EQ(conversion(d.inputs[2], joint::LoggedSignal::effort),
            conversion(d.inputs[1], joint::LoggedSignal::effort));
}

TEST(ColumnConversions, KnowWhatALoggerWritesByItsColumns) {
  const joint::Dataset d = read_two_logs();
  ASSERT_TRUE(d.inputs[1].logged_effort);
  EXPECT_EQ(d.inputs[1].logged_effort->logger, "UR RTDE");
  EXPECT_FALSE(d.inputs[2].logged_effort) << "its angle is of no logger that is known";
}

}  // namespace
}  // namespace tribolog::column_conversions_test
