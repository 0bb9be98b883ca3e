// Logs of robots that exist. They are not part of the project; see support/real_logs.h.

#include <cmath>

#include <gtest/gtest.h>

#include "ingest/dataset_file.h"
#include "pipeline.h"
#include "support/real_logs.h"

namespace tribolog {
namespace {

Calibration identify_manifest(const std::string& name, Dataset& dataset) {
  dataset = read_dataset(std::string(TRIBOLOG_SOURCE_DIR) + "/tests/data/" + name);
  return identify(dataset);
}

TEST(RealLog, Ur10eJoint2) {
  TRIBOLOG_NEEDS_REAL_LOG("ur10e_jointwise/joint_2.csv");
  Dataset dataset;
  const Calibration c = identify_manifest("ur10e_joint_2.toml", dataset);
  ASSERT_TRUE(c.rough.found);
  // 10.2 A at 10.696 N·m/A.
  EXPECT_NEAR(c.rough.gravity_Nm.value / (10.2 * 10.696), 1, 0.03);
  ASSERT_TRUE(c.friction.coulomb_viscous);
  EXPECT_GT(c.friction.coulomb_viscous->coulomb_Nm.value, 12);
  EXPECT_LT(c.friction.coulomb_viscous->coulomb_Nm.value, 16);
  EXPECT_EQ(c.quality.reference, "direction_difference");
  EXPECT_EQ(c.hysteresis.stage.state, StageState::not_identifiable);
  ASSERT_TRUE(c.hysteresis.encoder_step_rad && c.hysteresis.presliding_travel_rad);
  EXPECT_NEAR(*c.hysteresis.encoder_step_rad, 1e-4, 1e-8);
  // "Six steps of the encoder."
  EXPECT_NEAR(*c.hysteresis.presliding_travel_rad / *c.hysteresis.encoder_step_rad, 6, 4);
  EXPECT_NE(c.judgement.verdict, Verdict::usable);
}

TEST(RealLog, Ur10eJoint3) {
  TRIBOLOG_NEEDS_REAL_LOG("ur10e_jointwise/joint_3.csv");
  Dataset dataset;
  const Calibration c = identify_manifest("ur10e_joint_3.toml", dataset);
  ASSERT_TRUE(c.rough.found);
  EXPECT_NEAR(c.rough.gravity_Nm.value / (4.37 * 8.457), 1, 0.03);
  EXPECT_EQ(c.hysteresis.stage.state, StageState::not_identifiable);
}

TEST(RealLog, CiceseBreakAwayAndLoops) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/breakaway/breakaway_j1_05_exp.csv");
  Dataset dataset;
  const Calibration c = identify_manifest("cicese_break_away.toml", dataset);
  ASSERT_EQ(c.break_away.ramps.size(), 10U);
  // The first ramp stops at 10.07 N·m without a slip.
  EXPECT_EQ(c.break_away.censored, 1U);
  EXPECT_FALSE(c.break_away.ramps.front().broke_away);
  EXPECT_NEAR(c.break_away.ramps.front().friction_Nm, 10.066, 0.001);
  EXPECT_NE(c.break_away.stage.reason.find("larger than 10.07 N·m (censored"), std::string::npos);
  ASSERT_TRUE(c.break_away.rising_Nm && c.break_away.falling_Nm);
  EXPECT_NEAR(c.break_away.falling_Nm->value, 11.8, 0.3);  // the first leap in each of the plots
  EXPECT_LT(c.break_away.rising_Nm->low, c.break_away.falling_Nm->value);
  // Closed loops of 2.8e-4 rad.
  ASSERT_EQ(c.loop_shapes.size(), 3U);
  for (const LoopShape& shape : c.loop_shapes) {
    EXPECT_TRUE(shape.closes) << shape.recording;
    EXPECT_NEAR(shape.width_rad / 2.8e-4, 1, 0.1) << shape.recording;
    ASSERT_TRUE(shape.stiffness_Nm_rad) << shape.recording;
    EXPECT_NEAR(shape.stiffness_Nm_rad->value / 1.9e5, 1, 0.2) << shape.recording;
    EXPECT_LT(shape.stiffness_Nm_rad->half_width() / shape.stiffness_Nm_rad->value, 0.2);
  }
}

}  // namespace
}  // namespace tribolog
