#include <algorithm>
#include <array>

#include "ingest/layout/log_layout.h"

namespace tribolog::ingest::layout {

namespace {

using enum log::Quantity;

constexpr std::string_view needs_constant =
    "a motor current: it takes the torque constant of the motor";
constexpr std::string_view a_model =
    "a value of the controller's model, no measurement: friction found in it is the model's own";
constexpr std::string_view behind_the_gear =
    "measured behind the gear: most of the gear's friction is not in it";
constexpr std::string_view ampere_or_newton_metre =
    "drivers write amperes or newton metres under the same name: look which";

constexpr std::array ur_rtde = {
    KnownColumn{"timestamp", time, "s"}, KnownColumn{"actual_q_{}", angle, "rad"},
    KnownColumn{"actual_qd_{}", angular_speed, "rad/s"},
    // The longer name first: the shorter pattern would take its end for a joint.
    KnownColumn{"actual_current_as_torque_{}", torque, "Nm", false, joint::EffortKind::joint_torque,
                joint::Side::joint,
                "a current times the controller's own constant, with gravity taken off by the "
                "controller",
                false, true},
    KnownColumn{"actual_current_{}", current, "A", false, joint::EffortKind::motor_current,
                joint::Side::motor, needs_constant},
    KnownColumn{"actual_moment_{}", torque, "Nm", false, joint::EffortKind::joint_torque,
                joint::Side::joint},
    KnownColumn{"target_q_{}", angle, "rad", true},
    KnownColumn{"target_qd_{}", angular_speed, "rad/s", true},
    KnownColumn{"target_current_{}", current, "A", true, joint::EffortKind::motor_current,
                joint::Side::motor, a_model},
    KnownColumn{"target_moment_{}", torque, "Nm", true, joint::EffortKind::target_torque,
                joint::Side::joint, a_model},
    KnownColumn{"joint_temperatures_{}", temperature, "degC"}};

constexpr std::array libfranka = {
    KnownColumn{"time", time, "ms"},
    KnownColumn{"state.q[{}]", angle, "rad"},
    KnownColumn{"state.dq[{}]", angular_speed, "rad/s"},
    KnownColumn{"state.tau_J[{}]", torque, "Nm", false, joint::EffortKind::joint_torque,
                joint::Side::joint, behind_the_gear, true},
    KnownColumn{"state.q_d[{}]", angle, "rad", true},
    KnownColumn{"state.dq_d[{}]", angular_speed, "rad/s", true},
    KnownColumn{"cmd.q_d[{}]", angle, "rad", true},
    KnownColumn{"cmd.tau_J_d[{}]", torque, "Nm", true, joint::EffortKind::target_torque,
                joint::Side::joint, "a command, no measurement"}};

constexpr std::string_view of_outer_torque =
    "the controller's estimate of the outer torque, no measurement of the drive";

// Programs that write the fields of franka::RobotState by their names, in a unit of time of theirs.
constexpr std::array franka_state = {
    KnownColumn{"time", time, ""},
    KnownColumn{"timestamp", time, ""},
    KnownColumn{"t", time, ""},
    KnownColumn{"q[{}]", angle, "rad"},
    KnownColumn{"dq[{}]", angular_speed, "rad/s"},
    KnownColumn{"tau_J[{}]", torque, "Nm", false, joint::EffortKind::joint_torque,
                joint::Side::joint, behind_the_gear, true},
    KnownColumn{"q_d[{}]", angle, "rad", true},
    KnownColumn{"dq_d[{}]", angular_speed, "rad/s", true},
    KnownColumn{"tau_J_d[{}]", torque, "Nm", true, joint::EffortKind::target_torque,
                joint::Side::joint, "a command, no measurement"}};

// KUKA's RobotSensorInterface: the telegram's tags and attributes, as RSIPI and others log them,
// with or without who sends it in front. IPOC counts milliseconds.
constexpr std::string_view ampere_or_share =
    "RSI does not say its unit: amperes, or per cent of the largest current?";
constexpr std::array kuka_rsi = {
    KnownColumn{"time", time, ""},
    KnownColumn{"timestamp", time, ""},
    KnownColumn{"IPOC", time, "ms"},
    KnownColumn{"Send.IPOC", time, "ms"},
    KnownColumn{"AIPos.A{}", angle, "deg"},
    KnownColumn{"Send.AIPos.A{}", angle, "deg"},
    KnownColumn{"ASPos.A{}", angle, "deg", true},
    KnownColumn{"Send.ASPos.A{}", angle, "deg", true},
    KnownColumn{"MACur.A{}", current, "", false, joint::EffortKind::motor_current,
                joint::Side::motor, ampere_or_share},
    KnownColumn{"Send.MACur.A{}", current, "", false, joint::EffortKind::motor_current,
                joint::Side::motor, ampere_or_share},
    KnownColumn{"GearTorque.A{}", torque, "Nm", false, std::nullopt, joint::Side::joint},
    KnownColumn{"Send.GearTorque.A{}", torque, "Nm", false, std::nullopt, joint::Side::joint}};

// LBRState of lbr_fri_ros2_stack, with an index as it is flattened.
constexpr std::array kuka_fri_state = {
    KnownColumn{"time", time, ""},
    KnownColumn{"timestamp", time, ""},
    KnownColumn{"time_stamp_sec", time, "s"},
    KnownColumn{"measured_joint_position_{}", angle, "rad"},
    KnownColumn{"measured_joint_position[{}]", angle, "rad"},
    KnownColumn{"measured_torque_{}", torque, "Nm", false, joint::EffortKind::joint_torque,
                joint::Side::joint, behind_the_gear, true},
    KnownColumn{"measured_torque[{}]", torque, "Nm", false, joint::EffortKind::joint_torque,
                joint::Side::joint, behind_the_gear, true},
    KnownColumn{"commanded_joint_position_{}", angle, "rad", true},
    KnownColumn{"commanded_joint_position[{}]", angle, "rad", true},
    KnownColumn{"external_torque_{}", torque, "Nm", true, joint::EffortKind::target_torque,
                joint::Side::joint, of_outer_torque},
    KnownColumn{"external_torque[{}]", torque, "Nm", true, joint::EffortKind::target_torque,
                joint::Side::joint, of_outer_torque}};

// abb_libegm's EGMLogger; EGM sends degrees, and no torque.
constexpr std::array abb_egm = {KnownColumn{"TIMESTAMP", time, ""},
                                KnownColumn{"R_FB_POS_RJ{}", angle, "deg"},
                                KnownColumn{"R_FB_VEL_RJ{}", angular_speed, "deg/s"},
                                KnownColumn{"R_PL_POS_RJ{}", angle, "deg", true},
                                KnownColumn{"R_PL_VEL_RJ{}", angular_speed, "deg/s", true},
                                KnownColumn{"S_REF_POS_RJ{}", angle, "deg", true},
                                KnownColumn{"S_REF_VEL_RJ{}", angular_speed, "deg/s", true}};

constexpr std::array kuka_fri = {
    KnownColumn{"time", time, "s"}, KnownColumn{"mp{}", angle, "rad"},
    KnownColumn{"ip{}", angle, "rad", true},
    KnownColumn{"mt{}", torque, "Nm", false, joint::EffortKind::joint_torque, joint::Side::joint,
                behind_the_gear, true},
    KnownColumn{"et{}", torque, "Nm", true, joint::EffortKind::target_torque, joint::Side::joint,
                of_outer_torque}};

constexpr std::array flobaroid = {KnownColumn{"times", time, "s"},
                                  KnownColumn{"positions_{}", angle, "rad"},
                                  KnownColumn{"velocities_{}", angular_speed, "rad/s"},
                                  KnownColumn{"torques_{}", torque, "Nm", false,
                                              joint::EffortKind::joint_torque, joint::Side::joint},
                                  KnownColumn{"target_positions_{}", angle, "rad", true}};

// Of JointState; a DynamicJointState has the others too.
constexpr std::array joint_states = {
    KnownColumn{"time", time, "s"},
    KnownColumn{"{}.position", angle, "rad"},
    KnownColumn{"{}.velocity", angular_speed, "rad/s"},
    KnownColumn{"{}.current", current, "A", false, joint::EffortKind::motor_current,
                joint::Side::motor, needs_constant},
    KnownColumn{"{}.torque", torque, "Nm", false, std::nullopt, std::nullopt},
    KnownColumn{"{}.temperature", temperature, "degC"},
    KnownColumn{"{}.effort", torque, "Nm", false, std::nullopt, std::nullopt,
                ampere_or_newton_metre}};

/// Of a unit that the logger's versions and settings change.
constexpr KnownColumn usual(std::string_view pattern, log::Quantity quantity, std::string_view unit,
                            std::optional<joint::Side> side = {}) {
  return {pattern, quantity, unit, false, std::nullopt, side, "", false, false, true};
}

// Its position is in turns of the encoder, in older firmware in counts.
constexpr std::array odrive = {
    KnownColumn{"time", time, ""},
    KnownColumn{"timestamp", time, ""},
    KnownColumn{"t", time, ""},
    usual("pos_estimate", angle, "turn", joint::Side::motor),
    usual("{}.encoder.pos_estimate", angle, "turn", joint::Side::motor),  // the longer name first
    usual("{}.pos_estimate", angle, "turn", joint::Side::motor),
    usual("vel_estimate", angular_speed, "turn/s", joint::Side::motor),
    usual("{}.encoder.vel_estimate", angular_speed, "turn/s", joint::Side::motor),
    usual("{}.vel_estimate", angular_speed, "turn/s", joint::Side::motor),
    KnownColumn{"iq_measured", current, "A", false, joint::EffortKind::motor_current,
                joint::Side::motor, needs_constant},
    KnownColumn{"{}.motor.current_control.iq_measured", current, "A", false,
                joint::EffortKind::motor_current, joint::Side::motor, needs_constant},
    KnownColumn{"{}.iq_measured", current, "A", false, joint::EffortKind::motor_current,
                joint::Side::motor, needs_constant},
    KnownColumn{"torque_estimate", torque, "Nm", false, joint::EffortKind::motor_torque,
                joint::Side::motor, "a current times the controller's own constant"}};

constexpr std::array lerobot = {KnownColumn{"timestamp", time, "s"}, usual("{}.pos", angle, "deg"),
                                usual("{}.vel", angular_speed, "deg/s"),
                                KnownColumn{"{}.torque", torque, "Nm", false, std::nullopt,
                                            std::nullopt, ampere_or_newton_metre},
                                KnownColumn{"{}.effort", torque, "Nm", false, std::nullopt,
                                            std::nullopt, ampere_or_newton_metre}};

// Data sets of LeRobot, recognised by a column of theirs: the units are the robot's own, degrees,
// radians or per cent of its range, and no set states them.
constexpr std::array lerobot_set = {
    KnownColumn{"timestamp", time, "s"},
    KnownColumn{"{}.position_command", angle, "", true},
    KnownColumn{"{}.velocity_command", angular_speed, "", true},
    KnownColumn{"{}.effort_command", torque, "", true, std::nullopt, std::nullopt,
                "a command, no measurement"},
    KnownColumn{"{}.current_command", current, "", true, std::nullopt, std::nullopt,
                "a command, no measurement"},
    KnownColumn{"{}.pos", angle, ""},
    KnownColumn{"{}.position", angle, ""},
    KnownColumn{"observation.state_{}", angle, ""},
    KnownColumn{"{}.vel", angular_speed, ""},
    KnownColumn{"{}.velocity", angular_speed, ""},
    KnownColumn{"observation.velocity_{}", angular_speed, ""},
    KnownColumn{"{}.torque", torque, "Nm", false, std::nullopt, std::nullopt},
    KnownColumn{"observation.torque_{}", torque, "Nm", false, std::nullopt, std::nullopt},
    KnownColumn{"{}.effort", torque, "", false, std::nullopt, std::nullopt, ampere_or_newton_metre},
    KnownColumn{"observation.effort_{}", torque, "", false, std::nullopt, std::nullopt,
                ampere_or_newton_metre},
    KnownColumn{"{}.current", current, "", false, joint::EffortKind::motor_current,
                joint::Side::motor, needs_constant},
    KnownColumn{"observation.current_{}", current, "", false, joint::EffortKind::motor_current,
                joint::Side::motor, needs_constant},
    KnownColumn{"{}.temperature", temperature, "degC"},
    KnownColumn{"action_{}", angle, "", true}};

// Each quantity in a file of its own; the hyphen belongs to the name.
constexpr std::array figaroh = {KnownColumn{"t", time, "s"},
                                KnownColumn{"- {}_joint_position", angle, "rad"},
                                KnownColumn{"- {}_joint_velocity", angular_speed, "rad/s"},
                                KnownColumn{"- {}_joint_effort", torque, "Nm", false, std::nullopt,
                                            std::nullopt, ampere_or_newton_metre}};

constexpr std::array loggers = {
    KnownLogger{"UR RTDE", "actual_q_{}", ur_rtde},
    KnownLogger{"libfranka", "state.q[{}]", libfranka},
    KnownLogger{"libfranka", "tau_J[{}]", franka_state},
    KnownLogger{"KUKA FRI", "mp1", kuka_fri},
    KnownLogger{"KUKA FRI", "measured_joint_position_{}", kuka_fri_state},
    KnownLogger{"KUKA FRI", "measured_joint_position[{}]", kuka_fri_state},
    KnownLogger{"KUKA RSI", "AIPos.A{}", kuka_rsi},
    KnownLogger{"KUKA RSI", "Send.AIPos.A{}", kuka_rsi},
    KnownLogger{"ABB EGM", "R_FB_POS_RJ{}", abb_egm},
    KnownLogger{"FloBaRoID", "positions_{}", flobaroid},
    KnownLogger{"figaroh", "- {}_joint_position", figaroh},
    KnownLogger{"figaroh", "- {}_joint_velocity", figaroh},
    KnownLogger{"figaroh", "- {}_joint_effort", figaroh},
    KnownLogger{"LeRobot", "frame_index", lerobot_set},
    KnownLogger{"joint states", "{}.position", joint_states},
    KnownLogger{"ODrive", "pos_estimate", odrive},
    KnownLogger{"ODrive", "{}.pos_estimate", odrive},
    KnownLogger{"LeRobot", "{}.pos", lerobot}};

// KUKA's KRC: system variables, and the names of its trace, which states units in brackets; FANUC's
// system variable of the axes' angles.
constexpr std::array single_names = {
    KnownColumn{"$SCR_GRP[1].$MCH_ANG[{}]", angle, "rad"},
    KnownColumn{"$AXIS_ACT[{}]", angle, "deg"},
    KnownColumn{"$AXIS_ACT.A{}", angle, "deg"},
    KnownColumn{"$AXIS_ACT_MEAS[{}]", angle, "deg"},
    KnownColumn{"$AXIS_ACT_MEAS.A{}", angle, "deg"},
    KnownColumn{"AIPos_A{}", angle, ""},
    KnownColumn{"MACur_A{}", current, ""},
    KnownColumn{"$TORQUE_AXIS_ACT[{}]", torque, "Nm", false, joint::EffortKind::joint_torque,
                joint::Side::joint, "a current times the controller's own constant"}};

// Per cent of the largest current and speed.
constexpr std::array names_of_shares = {"$CURR_ACT[{}]", "$VEL_AXIS_ACT[{}]"};

}  // namespace

std::span<const KnownLogger> known_loggers() { return loggers; }

std::span<const KnownColumn> known_names() { return single_names; }

bool is_share_by_name(const std::string& name) {
  return std::any_of(names_of_shares.begin(), names_of_shares.end(),
                     [&](const char* pattern) { return joint_in_name(name, pattern).has_value(); });
}

namespace {

bool has_angle(const KnownLogger& logger, const std::string& column, const std::string& joint) {
  return std::any_of(logger.columns.begin(), logger.columns.end(), [&](const KnownColumn& known) {
    return known.quantity == log::Quantity::angle && joint_in_name(column, known.pattern) == joint;
  });
}

}  // namespace

std::optional<joint::LoggedEffort> known_effort(const std::string& angle_column,
                                                const std::string& effort_column) {
  for (const KnownLogger& logger : known_loggers()) {
    for (const KnownColumn& known : logger.columns) {
      if (known.quantity != log::Quantity::torque && known.quantity != log::Quantity::current)
        continue;
      const auto joint = joint_in_name(effort_column, known.pattern);
      if (!joint || !has_angle(logger, angle_column, *joint)) continue;
      return joint::LoggedEffort{
          std::string(logger.name), effort_column,       known.kind, known.side,
          known.is_target,          known.is_behind_gear};
    }
  }
  return std::nullopt;
}

}  // namespace tribolog::ingest::layout
