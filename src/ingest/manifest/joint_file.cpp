#include "ingest/manifest/joint_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/manifest/robot_joints.h"
#include "ingest/manifest/scenario_tables.h"
#include "ingest/manifest/toml_document.h"
#include "ingest/manifest/toml_table.h"
#include "wording/words.h"

namespace tribolog::ingest::manifest {

namespace {

/// A torque given at the motor or at the joint [N·m at the motor]; the key in use.
struct MotorTorque {
  std::string key;
  double Nm{};
};

std::optional<MotorTorque> find_torque(const TomlTable& table, const std::string& what,
                                       double gear_ratio) {
  const std::string at_motor = "motor_" + what;
  const std::string at_joint = "joint_" + what;
  const auto motor = table.find_number(at_motor, Sign::positive);
  const auto joint = table.find_number(at_joint, Sign::positive);
  if (motor && joint) table.refuse(at_joint, {"is given as " + at_motor + " too", "", "one", ""});
  if (motor) return MotorTorque{at_motor, *motor};
  if (joint) return MotorTorque{at_joint, *joint / gear_ratio};
  return std::nullopt;
}

std::optional<double> read_inertia(const TomlTable& joint, double gear_ratio) {
  const auto motor = joint.find_number("motor_inertia_kgm2", Sign::positive);
  const auto arm = joint.find_number("arm_inertia_kgm2", Sign::not_negative);
  if (motor.has_value() != arm.has_value()) {
    joint.refuse(motor ? "motor_inertia_kgm2" : "arm_inertia_kgm2",
                 {"is given alone", "", "motor_inertia_kgm2 and arm_inertia_kgm2, or neither", ""});
  }
  if (!motor) return std::nullopt;
  return *motor + *arm / (gear_ratio * gear_ratio);
}

void read_joint_table(const TomlTable& joint, joint::JointFacts& f) {
  f.joint = joint.text("name");
  f.gear_ratio = joint.number("gear_ratio", Sign::positive);
  f.lowest_rad = read_angle(joint, "lowest");
  f.highest_rad = read_angle(joint, "highest");
  f.speed_limit_rad_s = read_angular_rate(joint, "speed_limit", "_s");
  f.acceleration_limit_rad_s2 = read_angular_rate(joint, "acceleration_limit", "_s2");
  const auto torque = find_torque(joint, "torque_limit_Nm", f.gear_ratio);
  if (!torque) {
    joint.refuse("motor_torque_limit_Nm",
                 {"is missing", "", "a number", "or joint_torque_limit_Nm, at the joint"});
  }
  f.torque_limit_Nm = torque->Nm;
  f.inertia_kgm2 = read_inertia(joint, f.gear_ratio);
  joint.refuse_unknown_keys();
  const std::string highest = joint.has("highest_deg") ? "highest_deg" : "highest_rad";
  guarded(joint, highest, [&] {
    joint::check_joint_facts(f);
    return 0;
  });
}

/// Twice and six times the electrical frequency are cogging and commutation.
std::vector<double> periods_of(std::uint64_t pole_pairs, bool wave_generator) {
  std::vector<double> periods{1};
  if (wave_generator) periods.push_back(2);
  for (const double factor : {1.0, 2.0, 6.0}) {
    if (pole_pairs > 0) periods.push_back(factor * static_cast<double>(pole_pairs));
  }
  std::sort(periods.begin(), periods.end());
  periods.erase(std::unique(periods.begin(), periods.end()), periods.end());
  return periods;
}

void read_ripple(const TomlTable& ripple, joint::JointFacts& f) {
  f.ripple_amplitude_Nm = ripple.find_number("amplitude_Nm", Sign::not_negative);
  constexpr std::uint64_t most_pole_pairs = 100;
  const std::uint64_t pole_pairs = ripple.count_or("pole_pairs", 0);
  const bool wave_generator = ripple.flag_or("wave_generator", false);
  const bool by_build = ripple.has("pole_pairs") || ripple.has("wave_generator");
  if (ripple.has("periods_per_turn")) {
    if (by_build) {
      ripple.refuse("periods_per_turn", {"is given beside pole_pairs or wave_generator", "",
                                         "the periods or the build", ""});
    }
    f.ripple_periods_per_turn = ripple.numbers("periods_per_turn", Sign::positive);
    if (f.ripple_periods_per_turn.empty()) {
      ripple.refuse("periods_per_turn", {"is empty", "", "one number or more", ""});
    }
  } else if (by_build) {
    if (ripple.has("pole_pairs") && (pole_pairs < 1 || pole_pairs > most_pole_pairs)) {
      ripple.refuse("pole_pairs",
                    {"not usable", std::to_string(pole_pairs), "a whole number from 1 to 100", ""});
    }
    f.ripple_periods_per_turn = periods_of(pole_pairs, wave_generator);
  }
  ripple.refuse_unknown_keys();
}

void read_effort(const TomlTable& effort, joint::JointFacts& f) {
  f.effort_kind = static_cast<joint::EffortKind>(
      effort.choice("kind", {"motor_current", "motor_torque", "joint_torque"}));
  f.effort_side = static_cast<joint::Side>(effort.choice("side", {"motor", "joint"}));
  f.torque_constant_Nm_A = effort.find_number("torque_constant_Nm_A", Sign::positive);
  effort.refuse_unknown_keys();
  guarded(effort, "torque_constant_Nm_A", [&] {
    return joint::Drive(f.gear_ratio, f.effort_kind, f.effort_side, f.torque_constant_Nm_A);
  });
}

}  // namespace

std::vector<std::string> joints_to_plan(std::string_view text, const std::string& file) {
  precheck_toml(text, file);
  const TomlNode document = parse_toml(text, file);
  const TomlNode* schema = document.member("schema");
  const auto* stated = schema == nullptr ? nullptr : schema->as<std::string>();
  if (stated != nullptr && *stated == "tribolog-dataset-1") {
    throw InputError({file, schema->line, schema->column},
                     {"is a manifest of logs, which has no limits of a joint", in_quotes(*stated),
                      "'tribolog-joint-1'",
                      "a plan follows from limits of angle, speed, acceleration and torque; "
                      "examples/plan has a file of one joint and one of a robot"});
  }
  return joint_names(document, file);
}

joint::JointFacts parse_joint(std::string_view text, const std::string& file,
                              const std::string& joint) {
  precheck_toml(text, file);
  const TomlTable top = TomlTable::of(document_of_joint(parse_toml(text, file), file, joint), file);
  (void)top.choice("schema", {"tribolog-joint-1"});
  joint::JointFacts f;
  const TomlTable robot = top.table("robot");
  f.robot = robot.text("name");
  f.serial = robot.text_or("serial", "");
  robot.refuse_unknown_keys();
  read_joint_table(top.table("joint"), f);
  if (const auto gravity = top.find_table("gravity")) {
    if (const auto torque = find_torque(*gravity, "torque_Nm", f.gear_ratio)) {
      f.gravity_Nm = torque->Nm;
    }
    if (gravity->has("q_peak_deg") || gravity->has("q_peak_rad")) {
      f.q_peak_rad = read_angle(*gravity, "q_peak");
    }
    gravity->refuse_unknown_keys();
  }
  if (const auto friction = top.find_table("friction")) {
    f.static_Nm = friction->find_number("static_Nm", Sign::positive);
    f.coulomb_Nm = friction->find_number("coulomb_Nm", Sign::positive);
    f.stribeck_speed_rad_s = friction->find_number("stribeck_speed_rad_s", Sign::positive);
    f.bristle_stiffness_Nm_rad = friction->find_number("bristle_stiffness_Nm_rad", Sign::positive);
    friction->refuse_unknown_keys();
    guarded(*friction, "coulomb_Nm", [&] {
      joint::check_joint_facts(f);
      return 0;
    });
  }
  if (const auto log = top.find_table("log")) {
    f.sample_rate_Hz = log->find_number("sample_rate_Hz", Sign::positive);
    f.set_point_rate_Hz = log->find_number("set_point_rate_Hz", Sign::positive);
    f.encoder_counts_per_turn = log->find_number("encoder_counts_per_turn", Sign::positive);
    f.torque_noise_Nm = log->find_number("torque_noise_Nm", Sign::not_negative);
    f.torque_step_Nm = log->find_number("torque_step_Nm", Sign::not_negative);
    log->refuse_unknown_keys();
  }
  if (const auto ripple = top.find_table("ripple")) read_ripple(*ripple, f);
  if (const auto effort = top.find_table("effort")) read_effort(*effort, f);
  if (const auto budget = top.find_table("budget")) {
    f.time_budget_s = budget->find_number("time_s", Sign::positive);
    budget->refuse_unknown_keys();
  }
  top.refuse_unknown_keys();
  return f;
}

}  // namespace tribolog::ingest::manifest
