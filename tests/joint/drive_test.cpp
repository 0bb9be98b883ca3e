#include "joint/drive.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace tribolog {
namespace {

TEST(Drive, TurnsEveryKindOfEffortIntoMotorTorque) {
  // 2 A at 0.5 N·m/A on the motor; the same current with a gain for the joint behind a gear of 100.
  EXPECT_DOUBLE_EQ(
      2 * Drive(100, EffortKind::motor_current, Side::motor, 0.5).motor_torque_per_effort(), 1.0);
  EXPECT_DOUBLE_EQ(
      2 * Drive(100, EffortKind::motor_current, Side::joint, 50).motor_torque_per_effort(), 1.0);
  EXPECT_DOUBLE_EQ(Drive(100, EffortKind::motor_torque, Side::motor).motor_torque_per_effort(),
                   1.0);
  EXPECT_DOUBLE_EQ(
      100 * Drive(100, EffortKind::joint_torque, Side::joint).motor_torque_per_effort(), 1.0);
}

TEST(Drive, RefusesWhatCannotBe) {
  EXPECT_THROW(Drive(0, EffortKind::motor_torque, Side::motor), std::invalid_argument);
  EXPECT_THROW(Drive(-100, EffortKind::motor_torque, Side::motor), std::invalid_argument);
  EXPECT_THROW(Drive(100, EffortKind::motor_current, Side::motor), std::invalid_argument);
  EXPECT_THROW(Drive(100, EffortKind::motor_torque, Side::motor, 0.5), std::invalid_argument);
  EXPECT_THROW(Drive(100, EffortKind::motor_current, Side::motor, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog
