// Logs of real robots, where they lie beside the checkout.

#include "support/real_logs.h"

#include <gtest/gtest.h>

#include "ingest/dataset/dataset_file.h"
#include "wording/words.h"

namespace tribolog::real_logs_test {
namespace {

joint::Dataset manifest(const std::string& name) {
  return ingest::dataset::read_dataset(std::string(TRIBOLOG_SOURCE_DIR) + "/tests/data/" + name);
}

TEST(RealLogs, Ur10eJointsGiveTheirSine) {
  TRIBOLOG_NEEDS_REAL_LOG("ur10e_jointwise/joint_2.csv");
  const joint::Dataset two = manifest("ur10e_joint_2.toml");
  ASSERT_EQ(two.recordings.size(), 1U);
  const joint::Recording& r = two.recordings[0];
  EXPECT_EQ(r.rows_read, 6030U);
  EXPECT_GE(r.t_s.front(), 5.0);
  EXPECT_LE(r.t_s.back(), 62.3);
  EXPECT_EQ(r.size() + r.skipped.at(0).count, r.rows_read);
  EXPECT_EQ(wording::words(two.notes),
            std::vector<std::string>{"columns of the logs that are not used: "
                                     "'i_target_A', 'tau_target_Nm'"});
  EXPECT_EQ(manifest("ur10e_joint_3.toml").recordings.size(), 1U);
}

TEST(RealLogs, CiceseArmGivesOscillationsAndRuns) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  const joint::Dataset d = manifest("cicese_joint1.toml");
  EXPECT_EQ(d.with_role(joint::Role::oscillation).size(), 3U);
  EXPECT_EQ(d.with_role(joint::Role::constant_speed).size(), 40U);
  for (const joint::Recording& r : d.recordings) EXPECT_EQ(r.dq_rad_s.size(), r.size()) << r.name;
}

TEST(RealLogs, PendulumGivesMotionAndTemperatureButNoTorque) {
  TRIBOLOG_NEEDS_REAL_LOG("bam_xl330_pendulum/up_and_down_kp400.csv");
  const joint::Dataset d = manifest("bam_up_and_down.toml");
  ASSERT_EQ(d.recordings.size(), 1U);
  const joint::Recording& r = d.recordings[0];
  EXPECT_TRUE(r.torque_Nm.empty());
  ASSERT_EQ(r.temperature_C.size(), r.size());
  EXPECT_EQ(r.temperature_C.front(), 32);
  EXPECT_EQ(r.temperature_C.back(), 33);
}

}  // namespace
}  // namespace tribolog::real_logs_test
