// The known-truth check on logs of robots that exist: partial datasets, real noise, real clocks.

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "ingest/dataset/dataset_file.h"
#include "support/real_logs.h"

namespace tribolog::real_truth_check_test {
namespace {

using calibration::ReadingName;

calibration::TruthCheckResult check_of(const std::string& manifest) {
  const joint::Dataset dataset =
      ingest::dataset::read_dataset(std::string(TRIBOLOG_SOURCE_DIR) + "/tests/data/" + manifest);
  identify::IdentifyOptions options;
  options.truth_runs = 20;
  return identify::identify(dataset, options).truth_check;
}

TEST(RealTruthCheck, Ur10eSweepsFindTheirOwnAnswer) {
  TRIBOLOG_NEEDS_REAL_LOG("ur10e_jointwise/joint_2.csv");
  for (const char* manifest : {"ur10e_joint_2.toml", "ur10e_joint_3.toml"}) {
    const calibration::TruthCheckResult check = check_of(manifest);
    for (const ReadingName name :
         {ReadingName::model, ReadingName::q_peak, ReadingName::sweep_friction}) {
      const calibration::ReturnedQuantity* q = check.find(name);
      ASSERT_NE(q, nullptr) << manifest << to_string(name);
      EXPECT_TRUE(q->comes_back) << manifest << to_string(name);
      // 14 or fewer of 20 once in 400 checks with honest intervals.
      EXPECT_GE(q->inside, 15U) << manifest << to_string(name);
    }
    EXPECT_GT(check.white_Nm, 0);
    EXPECT_EQ(check.find(ReadingName::midline), nullptr);
  }
}

TEST(RealTruthCheck, WhatCiceseShowsComesBack) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  const calibration::TruthCheckResult check = check_of("cicese_joint1.toml");
  // Driven by torque the angle is no sine: the loops are simulated along the traced motion.
  ASSERT_NE(check.find(ReadingName::bristle_stiffness), nullptr);
  EXPECT_TRUE(check.find(ReadingName::bristle_stiffness)->comes_back);
  ASSERT_FALSE(check.quantities.empty());
  for (const calibration::ReturnedQuantity& q : check.quantities)
    EXPECT_EQ(q.found, 20U) << to_string(q.name);
}

}  // namespace
}  // namespace tribolog::real_truth_check_test
