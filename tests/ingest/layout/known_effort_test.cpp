// What known loggers write into the column that a manifest takes for the effort.

#include <gtest/gtest.h>

#include "ingest/layout/log_layout.h"

namespace tribolog::known_effort_test {
namespace {

TEST(KnownEffort, OfUrIsACurrentOrAModelsTarget) {
  const auto current = ingest::layout::known_effort("actual_q_0", "actual_current_0");
  ASSERT_TRUE(current);
  EXPECT_EQ(current->logger, "UR RTDE");
  EXPECT_EQ(current->column, "actual_current_0");
  EXPECT_EQ(current->kind, joint::EffortKind::motor_current);
  EXPECT_FALSE(current->is_target);
  const auto target = ingest::layout::known_effort("actual_q_3", "target_moment_3");
  ASSERT_TRUE(target);
  EXPECT_EQ(target->kind, joint::EffortKind::target_torque);
  EXPECT_TRUE(target->is_target);
  EXPECT_TRUE(ingest::layout::known_effort("actual_q_3", "target_current_3")->is_target);
}

TEST(KnownEffort, OfFrankaAndKukaIsBehindTheGear) {
  EXPECT_TRUE(ingest::layout::known_effort("state.q[3]", "state.tau_J[3]")->is_behind_gear);
  EXPECT_TRUE(ingest::layout::known_effort("mp7", "mt7")->is_behind_gear);
  EXPECT_TRUE(ingest::layout::known_effort("q[2]", "tau_J[2]")->is_behind_gear);
  EXPECT_TRUE(ingest::layout::known_effort("measured_joint_position_0", "measured_torque_0")
                  ->is_behind_gear);
  EXPECT_FALSE(ingest::layout::known_effort("positions_1", "torques_1")->is_behind_gear);
}

TEST(KnownEffort, OfRosMayBeOneOrTheOther) {
  const auto effort = ingest::layout::known_effort("elbow.position", "elbow.effort");
  ASSERT_TRUE(effort);
  EXPECT_FALSE(effort->kind);
}

TEST(KnownEffort, IsNotGuessedFromOneNameAloneOrFromAnotherJoint) {
  EXPECT_FALSE(ingest::layout::known_effort("q", "mt1"));
  EXPECT_FALSE(ingest::layout::known_effort("actual_q_1", "actual_current_0"));
  EXPECT_FALSE(ingest::layout::known_effort("q_rad", "tau_Nm"));
}

}  // namespace
}  // namespace tribolog::known_effort_test
