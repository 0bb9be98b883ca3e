// Columns known by their names.

#include "ingest/layout/log_layout.h"

#include <utility>

#include <gtest/gtest.h>

#include "ingest/text/csv_dialect.h"

namespace tribolog::log_layout_test {
namespace {

ingest::layout::LogLayout layout_of(const std::vector<std::string>& names) {
  std::vector<ingest::log::ColumnHeader> header;
  for (const std::string& name : names) header.push_back(ingest::text::read_header_field(name));
  return ingest::layout::guess_layout(header);
}

TEST(NamePattern, FindsTheJoint) {
  EXPECT_EQ(ingest::layout::joint_in_name("actual_q_0", "actual_q_{}"), "0");
  EXPECT_EQ(ingest::layout::joint_in_name("State.tau_j[3]", "state.tau_J[{}]"), "3");
  EXPECT_EQ(ingest::layout::joint_in_name("left.elbow.position", "{}.position"), "left.elbow");
  EXPECT_EQ(ingest::layout::joint_in_name("TIME", "time"), "");
  EXPECT_FALSE(ingest::layout::joint_in_name("actual_q_", "actual_q_{}"));
  EXPECT_FALSE(ingest::layout::joint_in_name("actual_qd_0", "actual_q_{}"));
  EXPECT_FALSE(ingest::layout::joint_in_name("", "{}"));
}

TEST(LogLayout, ASetPointIsNoMeasurementInOtherLanguagesEither) {
  using enum ingest::log::Quantity;
  for (const auto& [target, actual] :
       {std::pair{"Sollstrom_A", "Iststrom_A"}, std::pair{"Soll Strom [A]", "Ist Strom [A]"},
        std::pair{"prad_zadany_A", "prad_rzeczywisty_A"},
        std::pair{"demand current [A]", "actual current [A]"},
        std::pair{"nominal_current_A", "current_A"}, std::pair{"req_current_A", "current_A"},
        std::pair{"sim_current_A", "meas_current_A"}}) {
    const ingest::layout::LogLayout l = layout_of({"t_s", "q_deg", target, actual});
    ASSERT_NE(l.find(current, ""), nullptr) << target;
    EXPECT_EQ(l.find(current, "")->column, 3U) << target;
  }
}

TEST(LogLayout, WhatIsCurrentNowIsNoElectricCurrent) {
  using enum ingest::log::Quantity;
  const ingest::layout::LogLayout l =
      layout_of({"t_s", "current_position_deg", "cur_vel", "motor_current"});
  ASSERT_NE(l.find(angle, ""), nullptr);
  EXPECT_EQ(l.find(angle, "")->column, 1U);
  ASSERT_NE(l.find(angular_speed, ""), nullptr);
  ASSERT_NE(l.find(current, ""), nullptr);
  EXPECT_EQ(l.find(current, "")->column, 3U);
}

TEST(LogLayout, SharesAndCountsAreInNoUnit) {
  const ingest::layout::LogLayout l = layout_of({"t_s", "q_deg", "torque_percent", "pos_inc"});
  EXPECT_EQ(l.columns.size(), 2U);
  EXPECT_EQ(l.foreign.size(), 2U);
}

TEST(LogLayout, KnowsUrsRealTimeLog) {
  const ingest::layout::LogLayout l =
      layout_of({"timestamp", "target_q_0", "actual_q_0", "actual_q_5", "actual_qd_0",
                 "actual_current_0", "target_moment_0", "joint_temperatures_0", "safety_status"});
  EXPECT_EQ(l.logger, "UR RTDE");
  EXPECT_EQ(l.joints(), (std::vector<std::string>{"0", "5"}));
  ASSERT_NE(l.find(ingest::log::Quantity::angle, "0"), nullptr);
  EXPECT_EQ(l.find(ingest::log::Quantity::angle, "0")->column, 2U)
      << "the measured one, not the target";
  ASSERT_NE(l.find(ingest::log::Quantity::current, "0"), nullptr);
  EXPECT_EQ(l.find(ingest::log::Quantity::current, "0")->effort.kind,
            joint::EffortKind::motor_current);
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, "0"), nullptr)
      << "a model's value is no measurement";
  EXPECT_EQ(l.columns[6].effort.kind, joint::EffortKind::target_torque);
  EXPECT_EQ(l.find(ingest::log::Quantity::temperature, "0")->unit, "degC");
  EXPECT_EQ(l.columns.size(), 8U);
}

// Of PolyScope 5.21 and later; beside the current itself, whose name is the start of this one.
TEST(LogLayout, KnowsUrsCurrentAsTorqueFromWhichGravityIsTaken) {
  const ingest::layout::LogLayout l =
      layout_of({"timestamp", "actual_q_0", "actual_current_0", "actual_current_as_torque_0"});
  EXPECT_EQ(l.logger, "UR RTDE");
  EXPECT_EQ(l.joints(), std::vector<std::string>{"0"});
  const ingest::layout::ColumnMeaning* torque = l.find(ingest::log::Quantity::torque, "0");
  ASSERT_NE(torque, nullptr);
  EXPECT_EQ(torque->column, 3U);
  EXPECT_EQ(torque->effort.kind, joint::EffortKind::joint_torque);
  EXPECT_TRUE(torque->effort.is_without_gravity);
  const ingest::layout::ColumnMeaning* current = l.find(ingest::log::Quantity::current, "0");
  ASSERT_NE(current, nullptr);
  EXPECT_EQ(current->column, 2U);
  EXPECT_FALSE(current->effort.is_without_gravity);
}

TEST(LogLayout, KnowsOdrivesPropertiesByTheirPaths) {
  using enum ingest::log::Quantity;
  const std::vector<std::vector<std::string>> logs{
      {"time", "axis0.encoder.pos_estimate", "axis0.encoder.vel_estimate",
       "axis0.motor.current_control.Iq_measured"},
      {"time", "axis0.pos_estimate", "axis0.vel_estimate", "axis0.iq_measured"},
      {"time", "pos_estimate", "vel_estimate", "iq_measured"}};
  for (const std::vector<std::string>& names : logs) {
    const ingest::layout::LogLayout l = layout_of(names);
    const std::string joint = names[1] == "pos_estimate" ? "" : "axis0";
    EXPECT_EQ(l.logger, "ODrive") << names[1];
    ASSERT_NE(l.find(angle, joint), nullptr) << names[1];
    EXPECT_EQ(l.find(angle, joint)->unit, "turn");
    EXPECT_FALSE(l.find(angle, joint)->unit_is_stated) << "older firmware counts";
    ASSERT_NE(l.find(angular_speed, joint), nullptr) << names[2];
    EXPECT_EQ(l.find(angular_speed, joint)->unit, "turn/s");
    ASSERT_NE(l.find(current, joint), nullptr) << names[3];
    EXPECT_EQ(l.find(current, joint)->effort.kind, joint::EffortKind::motor_current);
  }
}

TEST(LogLayout, UnitsOfLeRobotAreUsualOnes) {
  const ingest::layout::LogLayout l = layout_of({"timestamp", "elbow.pos", "elbow.torque"});
  EXPECT_EQ(l.logger, "LeRobot");
  ASSERT_NE(l.find(ingest::log::Quantity::angle, "elbow"), nullptr);
  EXPECT_FALSE(l.find(ingest::log::Quantity::angle, "elbow")->unit_is_stated);
}

TEST(LogLayout, KnowsThatFrankaMeasuresBehindTheGearAndCountsMilliseconds) {
  const ingest::layout::LogLayout l =
      layout_of({"time", "success_rate", "state.q[0]", "state.q_d[0]", "state.dq[0]",
                 "state.tau_J[0]", "cmd.tau_J_d[0]"});
  EXPECT_EQ(l.logger, "libfranka");
  EXPECT_EQ(l.find(ingest::log::Quantity::time, "")->unit, "ms");
  const ingest::layout::ColumnMeaning* torque = l.find(ingest::log::Quantity::torque, "0");
  ASSERT_NE(torque, nullptr);
  EXPECT_EQ(torque->effort.side, joint::Side::joint);
  EXPECT_NE(torque->effort.remark.find("behind the gear"), std::string::npos);
}

// The fields of franka::RobotState, as its documentation names them.
TEST(LogLayout, KnowsFrankasStateByItsFields) {
  const ingest::layout::LogLayout l =
      layout_of({"time", "q[0]", "q[1]", "dq[0]", "tau_J[0]", "tau_J_d[0]", "q_d[0]",
                 "tau_ext_hat_filtered[0]", "O_T_EE[12]"});
  EXPECT_EQ(l.logger, "libfranka");
  EXPECT_EQ(l.joints(), (std::vector<std::string>{"0", "1"}));
  EXPECT_FALSE(l.find(ingest::log::Quantity::time, "")->unit_is_stated);
  ASSERT_NE(l.find(ingest::log::Quantity::torque, "0"), nullptr);
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, "0")->column, 4U);
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, "0")->effort.side, joint::Side::joint);
}

// Tags and attributes of RSI's telegram, joined by a point as RSIPI's logger does.
TEST(LogLayout, KnowsKukasRsi) {
  for (const std::string sender : {"", "Send."}) {
    const ingest::layout::LogLayout l = layout_of(
        {sender + "IPOC", sender + "RIst.X", sender + "RIst.A", sender + "AIPos.A1",
         sender + "AIPos.A2", sender + "ASPos.A1", sender + "MACur.A1", "Receive.RKorr.X"});
    EXPECT_EQ(l.logger, "KUKA RSI");
    EXPECT_EQ(l.joints(), (std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(l.find(ingest::log::Quantity::time, "")->unit, "ms");
    EXPECT_EQ(l.find(ingest::log::Quantity::angle, "1")->unit, "deg");
    ASSERT_NE(l.find(ingest::log::Quantity::current, "1"), nullptr);
    EXPECT_FALSE(l.find(ingest::log::Quantity::current, "1")->unit_is_stated);
    EXPECT_EQ(l.columns.size(), 5U) << "no pose of the tool";
  }
}

// LBRState of lbr_fri_ros2_stack.
TEST(LogLayout, KnowsKukasFriByItsStatesFields) {
  const ingest::layout::LogLayout l =
      layout_of({"time", "external_torque_0", "measured_joint_position_0", "measured_torque_0",
                 "commanded_joint_position_0"});
  EXPECT_EQ(l.logger, "KUKA FRI");
  ASSERT_NE(l.find(ingest::log::Quantity::torque, "0"), nullptr);
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, "0")->column, 3U) << "the outer one is a guess";
}

// The columns of abb_libegm's EGMLogger; those of rpiRobotics/abb_motion_program_exec.
TEST(LogLayout, KnowsWhatAbbsRobotsLog) {
  const ingest::layout::LogLayout egm =
      layout_of({"TIMESTAMP", "R_FB_POS_RJ1", "R_FB_POS_EJ1", "R_FB_VEL_RJ1", "R_FB_POS_X",
                 "R_PL_POS_RJ1", "S_REF_POS_RJ1"});
  EXPECT_EQ(egm.logger, "ABB EGM");
  EXPECT_EQ(egm.joints(), std::vector<std::string>{"1"});
  EXPECT_EQ(egm.find(ingest::log::Quantity::angle, "1")->column, 1U);
  EXPECT_EQ(egm.find(ingest::log::Quantity::angular_speed, "1")->unit, "deg/s");
  const ingest::layout::LogLayout program =
      layout_of({"timestamp", "cmdnum", "J1", "J2", "J3", "J4", "J5", "J6"});
  EXPECT_EQ(program.joints(), (std::vector<std::string>{"1", "2", "3", "4", "5", "6"}));
  EXPECT_FALSE(program.find(ingest::log::Quantity::angle, "6")->unit_is_stated);
  // A drive's reference is no measurement.
  const ingest::layout::LogLayout signals =
      layout_of({"Time [s]", "Joint position 1 [deg]", "torque_ref 1 [Nm]"});
  EXPECT_EQ(signals.joints(), std::vector<std::string>{"1"});
  ASSERT_EQ(signals.columns.size(), 3U);
  EXPECT_TRUE(signals.columns[2].is_target);
  EXPECT_EQ(signals.columns[2].joint, "1");
}

// FANUC's system variable; tables of a pendant, whose torques are in per cent.
TEST(LogLayout, KnowsWhatFanucsRobotsLog) {
  const ingest::layout::LogLayout l =
      layout_of({"Time [ms]", "$SCR_GRP[1].$MCH_ANG[3]", "J3 torque [%]"});
  EXPECT_EQ(l.joints(), std::vector<std::string>{"3"});
  EXPECT_EQ(l.find(ingest::log::Quantity::angle, "3")->unit, "rad");
  ASSERT_EQ(l.foreign.size(), 1U);
  EXPECT_EQ(l.foreign[0].joint, "3");
  const ingest::layout::LogLayout pendant =
      layout_of({"Time", "J1 (deg)", "J1 current (A)", "J2 (deg)"});
  EXPECT_EQ(pendant.joints(), (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(pendant.find(ingest::log::Quantity::current, "1")->unit, "A");
}

TEST(LogLayout, AJointsNameIsNoAngleBesideOne) {
  const ingest::layout::LogLayout l = layout_of({"t", "q1", "J1", "J2"});
  EXPECT_EQ(l.joints(), std::vector<std::string>{"1"});
  EXPECT_EQ(l.columns.size(), 2U);
}

TEST(LogLayout, KnowsTheOthersToo) {
  EXPECT_EQ(layout_of({"index", "time", "mp1", "ip1", "mt1", "et1"}).logger, "KUKA FRI");
  EXPECT_EQ(
      layout_of({"index", "time", "mp1", "mt1"}).find(ingest::log::Quantity::angular_speed, "1"),
      nullptr);
  EXPECT_EQ(layout_of({"times", "positions_0", "torques_0"}).logger, "FloBaRoID");
  const ingest::layout::LogLayout positions =
      layout_of({"t", "- torso_lift_joint_position", "- arm_1_joint_position"});
  EXPECT_EQ(positions.logger, "figaroh");
  EXPECT_EQ(positions.joints(), (std::vector<std::string>{"torso_lift", "arm_1"}));
  const ingest::layout::LogLayout efforts =
      layout_of({"t", "- torso_lift_joint_effort", "- arm_1_joint_effort"});
  EXPECT_EQ(efforts.logger, "figaroh");
  ASSERT_NE(efforts.find(ingest::log::Quantity::torque, "arm_1"), nullptr);
  EXPECT_FALSE(efforts.find(ingest::log::Quantity::torque, "arm_1")->effort.kind);
  const ingest::layout::LogLayout ros =
      layout_of({"time", "elbow.position", "elbow.velocity", "elbow.effort"});
  EXPECT_EQ(ros.logger, "joint states");
  // Nobody can tell amperes from newton metres here.
  EXPECT_FALSE(ros.find(ingest::log::Quantity::torque, "elbow")->effort.kind);
  EXPECT_EQ(layout_of({"timestamp", "joint1.pos", "joint1.effort"}).logger, "LeRobot");
}

TEST(LogLayout, ReadsOtherNamesWordByWord) {
  const ingest::layout::LogLayout l =
      layout_of({"t_ms", "q_deg", "dq_rad_s", "i_A", "tau [mNm]", "temp", "note"});
  EXPECT_TRUE(l.logger.empty());
  EXPECT_EQ(l.joints(), std::vector<std::string>{""});
  EXPECT_EQ(l.find(ingest::log::Quantity::time, "")->unit, "ms");
  EXPECT_EQ(l.find(ingest::log::Quantity::angle, "")->unit, "deg");
  EXPECT_EQ(l.find(ingest::log::Quantity::angular_speed, "")->unit, "rad/s");
  EXPECT_EQ(l.find(ingest::log::Quantity::current, "")->unit, "A");
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, "")->unit, "mNm");
  EXPECT_FALSE(l.find(ingest::log::Quantity::temperature, "")->unit_is_stated);
  EXPECT_EQ(l.columns.size(), 6U);
}

TEST(LogLayout, ReadsWordsInAnyOrder) {
  const ingest::layout::LogLayout l = layout_of(
      {"elapsed_ms", "elbow_position", "elbow_velocity", "motorCurrent_elbow_A", "tau_target_Nm",
       "q_goal_rad", "torque_enable", "position_error", "Strom [mA]", "u_motor_V", "temp_C"});
  EXPECT_EQ(l.find(ingest::log::Quantity::time, "")->unit, "ms");
  EXPECT_EQ(l.joints(), std::vector<std::string>{"elbow"});
  ASSERT_NE(l.find(ingest::log::Quantity::current, "elbow"), nullptr);
  EXPECT_EQ(l.find(ingest::log::Quantity::current, "elbow")->column, 3U);
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, ""), nullptr) << "a set point, a switch";
  EXPECT_EQ(l.find(ingest::log::Quantity::current, "")->column, 8U) << "by its unit alone";
  EXPECT_EQ(l.find(ingest::log::Quantity::temperature, "")->unit, "degC");
  EXPECT_EQ(l.columns.size(), 8U);
}

TEST(LogLayout, UnitsAreReadAsPeopleSpellThem) {
  const ingest::layout::LogLayout l =
      layout_of({"time [sec]", "position [degrees]", "velocity [Hz]", "temperature [C]"});
  for (const auto quantity : {ingest::log::Quantity::angle, ingest::log::Quantity::angular_speed,
                              ingest::log::Quantity::temperature}) {
    ASSERT_NE(l.find(quantity, ""), nullptr);
    EXPECT_TRUE(l.find(quantity, "")->unit_is_stated);
  }
  constexpr double pi = 3.141592653589793;
  EXPECT_NEAR(*ingest::log::find_si_factor(ingest::log::Quantity::angular_speed, "Hz"), 2 * pi,
              1e-12);
  EXPECT_NEAR(*ingest::log::find_si_factor(ingest::log::Quantity::angle, "degrees"), pi / 180,
              1e-12);
  EXPECT_EQ(*ingest::log::find_si_factor(ingest::log::Quantity::temperature, "C"), 1);
}

TEST(LogLayout, NumbersBehindTheWordAreJoints) {
  const ingest::layout::LogLayout l =
      layout_of({"Time", "q1_rad", "q2_rad", "tau1_Nm", "current_2", "pos[3]"});
  EXPECT_EQ(l.joints(), (std::vector<std::string>{"1", "2", "3"}));
  EXPECT_NE(l.find(ingest::log::Quantity::torque, "1"), nullptr);
  EXPECT_NE(l.find(ingest::log::Quantity::current, "2"), nullptr);
}

TEST(LogLayout, TakesOfAPathWhatIsSaidLast) {
  const ingest::layout::LogLayout l =
      layout_of({"__time", "/joint_states/elbow_joint/position", "/joint_states/wrist/position",
                 "/left/joint_states/elbow_joint/effort"});
  EXPECT_EQ(l.joints(), (std::vector<std::string>{"elbow", "wrist"}));
  ASSERT_NE(l.find(ingest::log::Quantity::torque, "elbow"), nullptr);
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, "elbow")->column, 3U);
}

TEST(LogLayout, AUnitThatIsNotKnownIsNoRadian) {
  const ingest::layout::LogLayout l =
      layout_of({"Time [ms]", "Position actual value [qc]", "Torque [%]", "q[0]",
                 "Velocity actual value [rpm]", "Sum [qc]"});
  EXPECT_EQ(l.joints(), std::vector<std::string>{"0"});
  EXPECT_EQ(l.find(ingest::log::Quantity::torque, ""), nullptr);
  ASSERT_EQ(l.foreign.size(), 2U);
  EXPECT_EQ(l.foreign[0].column, 1U);
  EXPECT_EQ(l.foreign[0].quantity, ingest::log::Quantity::angle);
  EXPECT_EQ(l.foreign[1].column, 2U);
  EXPECT_EQ(l.foreign[1].quantity, ingest::log::Quantity::torque);
}

TEST(LogLayout, SaysNothingOfWhatItDoesNotKnow) {
  EXPECT_TRUE(layout_of({"quality", "tick", "id", "", "status", "information"}).columns.empty());
}

}  // namespace
}  // namespace tribolog::log_layout_test
