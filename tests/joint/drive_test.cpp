#include "joint/drive.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace tribolog::drive_test {
namespace {

TEST(Drive, TurnsEveryKindOfEffortIntoMotorTorque) {
  // 2 A at 0.5 N·m/A on the motor; the same current with a gain for the joint behind a gear of 100.
  EXPECT_DOUBLE_EQ(2 * joint::Drive(100, joint::EffortKind::motor_current, joint::Side::motor, 0.5)
                           .motor_torque_per_effort(),
                   1.0);
  EXPECT_DOUBLE_EQ(2 * joint::Drive(100, joint::EffortKind::motor_current, joint::Side::joint, 50)
                           .motor_torque_per_effort(),
                   1.0);
  EXPECT_DOUBLE_EQ(joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor)
                       .motor_torque_per_effort(),
                   1.0);
  EXPECT_DOUBLE_EQ(100 * joint::Drive(100, joint::EffortKind::joint_torque, joint::Side::joint)
                             .motor_torque_per_effort(),
                   1.0);
}

TEST(Drive, RefusesWhatCannotBe) {
  EXPECT_THROW(joint::Drive(0, joint::EffortKind::motor_torque, joint::Side::motor),
               std::invalid_argument);
  EXPECT_THROW(joint::Drive(-100, joint::EffortKind::motor_torque, joint::Side::motor),
               std::invalid_argument);
  EXPECT_THROW(joint::Drive(100, joint::EffortKind::motor_current, joint::Side::motor),
               std::invalid_argument);
  EXPECT_THROW(joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor, 0.5),
               std::invalid_argument);
  EXPECT_THROW(joint::Drive(100, joint::EffortKind::motor_current, joint::Side::motor, 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::drive_test
