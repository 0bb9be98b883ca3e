#include <gtest/gtest.h>

#include "joint/dataset.h"
#include "joint/drive.h"

namespace tribolog::column_conversion_test {
namespace {

using Reason = joint::ConversionStep::Reason;

joint::ColumnConversion angle_in(const std::string& unit) {
  return {joint::LoggedSignal::angle, "q", unit, {}, "rad", joint::Side::joint};
}

joint::InputFile log(const std::string& name,
                     const std::vector<joint::ColumnConversion>& conversions) {
  joint::InputFile file;
  file.name = name;
  file.conversions = conversions;
  return file;
}

TEST(ColumnConversion, OfNoStepsChangesNothing) { EXPECT_EQ(angle_in("rad").factor(), 1.0); }

TEST(ColumnConversion, IsTheProductOfItsSteps) {
  // 250 mA, sign turned, 40 N·m/A at the joint, gear of 80: -0.125 N·m at the motor.
  const joint::ColumnConversion effort{joint::LoggedSignal::effort,
                                       "i",
                                       "mA",
                                       {{Reason::unit, 1e-3},
                                        {Reason::sign, -1},
                                        {Reason::torque_constant, 40},
                                        {Reason::gear, 80, true}},
                                       "N·m",
                                       joint::Side::motor};
  EXPECT_DOUBLE_EQ(250 * effort.factor(), -0.125);
}

TEST(ColumnConversion, ToMotorTorqueIsTheDrives) {
  for (const joint::Drive& drive :
       {joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor),
        joint::Drive(80, joint::EffortKind::joint_torque, joint::Side::joint),
        joint::Drive(101, joint::EffortKind::motor_current, joint::Side::joint, 10.696),
        joint::Drive(50, joint::EffortKind::target_torque, joint::Side::joint)}) {
    EXPECT_EQ(joint::factor_of(joint::steps_to_motor_torque(drive)),
              drive.motor_torque_per_effort());
  }
  // Nothing to tell where nothing is done.
  EXPECT_TRUE(joint::steps_to_motor_torque(
                  joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor))
                  .empty());
  EXPECT_TRUE(joint::steps_to_motor_torque(
                  joint::Drive(1, joint::EffortKind::joint_torque, joint::Side::joint))
                  .empty());
}

TEST(SharedConversions, TellOnceWhatLogsHaveInCommon) {
  const joint::ColumnConversion time{joint::LoggedSignal::time, "t", "s", {}, "s", std::nullopt};
  joint::InputFile manifest;
  manifest.name = "dataset.toml";
  const auto shared =
      joint::shared_conversions({manifest, log("a.csv", {time, angle_in("rad")}),
                                 log("b.csv", {time, angle_in("deg")}), log("b.csv", {time})});
  ASSERT_EQ(shared.size(), 3U);
  EXPECT_EQ(shared[0].conversion.signal, joint::LoggedSignal::time);
  EXPECT_TRUE(shared[0].is_of_all) << "the manifest is no log, and b.csv is one";
  EXPECT_EQ(shared[0].files, (std::vector<std::string>{"a.csv", "b.csv"}));
  EXPECT_EQ(shared[1].conversion.unit, "rad");
  EXPECT_FALSE(shared[1].is_of_all);
  EXPECT_EQ(shared[2].conversion.unit, "deg");
  EXPECT_EQ(shared[2].files, std::vector<std::string>{"b.csv"});
  EXPECT_TRUE(joint::shared_conversions({manifest}).empty());
}

}  // namespace
}  // namespace tribolog::column_conversion_test
