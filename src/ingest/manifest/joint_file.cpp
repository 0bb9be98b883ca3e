#include "ingest/manifest/joint_file.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/arrays/json_text.h"
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

// What an earlier calibration tells a plan.

namespace {

const arrays::JsonValue* member(const arrays::JsonValue* object, std::string_view key) {
  if (object == nullptr || object->kind != arrays::JsonKind::object) return nullptr;
  for (std::size_t i = 0; i < object->content->keys.size(); ++i) {
    if (object->content->keys[i] == key) return &object->content->elements[i];
  }
  return nullptr;
}

const arrays::JsonValue* at(const arrays::JsonValue& top, std::initializer_list<const char*> path) {
  const arrays::JsonValue* value = &top;
  for (const char* key : path) value = member(value, key);
  return value;
}

std::optional<double> number_at(const arrays::JsonValue& top,
                                std::initializer_list<const char*> path) {
  const arrays::JsonValue* value = at(top, path);
  if (value == nullptr || value->kind != arrays::JsonKind::number) return std::nullopt;
  return value->number;
}

std::vector<double> ripple_periods(const arrays::JsonValue& top) {
  std::vector<double> periods;
  const arrays::JsonValue* lines = at(top, {"ripple", "lines"});
  if (lines == nullptr || lines->kind != arrays::JsonKind::array) return periods;
  for (const arrays::JsonValue& line : lines->content->elements) {
    const auto period = number_at(line, {"periods_per_turn"});
    if (period && *period > 0 && range_of_key("periods_per_turn").holds(*period)) {
      periods.push_back(*period);
    }
  }
  return periods;
}

/// What the calibration gives, in the ranges that a joint's file has.
class Taken {
 public:
  Taken(joint::JointFacts& facts, const std::string& file) : facts_(facts), file_(file) {}

  void take(const char* name, std::optional<double>& fact, const std::optional<double>& found) {
    if (!found) return;
    const KeyRange range = range_of_key(name);
    if (!range.holds(*found)) {
      throw InputError({file_, 0, 0}, {std::string(name) + " is out of any joint's range",
                                       fmt::format("{}", *found), range.in_words(), ""});
    }
    fact = found;
    facts_.identified.insert(name);
  }

  /// Only where the joint's file does not state it.
  void fill(const char* name, std::optional<double>& fact, const std::optional<double>& found) {
    if (!fact && found && *found > 0) take(name, fact, found);
  }

 private:
  joint::JointFacts& facts_;
  const std::string& file_;
};

}  // namespace

joint::JointFacts with_calibration(joint::JointFacts f, std::string_view calibration,
                                   const std::string& file) {
  const arrays::JsonValue top = arrays::parse_json_text(calibration, file);
  const arrays::JsonValue* schema = at(top, {"schema"});
  if (schema == nullptr || schema->kind != arrays::JsonKind::text ||
      schema->content->text != "tribolog-calibration-1") {
    throw InputError({file, 0, 0}, {"is no calibration", "", "schema \"tribolog-calibration-1\"",
                                    "tribolog identify writes one"});
  }
  const auto gear_ratio = number_at(top, {"drive", "gear_ratio"});
  constexpr double same = 1e-9;
  if (gear_ratio && std::abs(*gear_ratio - f.gear_ratio) > same * f.gear_ratio) {
    throw InputError({file, 0, 0}, {"is of another gear ratio", fmt::format("{}", *gear_ratio),
                                    fmt::format("{}, as the joint's", f.gear_ratio), ""});
  }
  Taken taken(f, file);
  taken.take("q_peak_rad", f.q_peak_rad, number_at(top, {"cog", "q_peak_rad", "estimate"}));
  const auto gravity = number_at(top, {"cog", "rough", "gravity_Nm", "estimate"});
  if (gravity && *gravity > 0) taken.take("gravity_Nm", f.gravity_Nm, gravity);
  if (f.ripple_periods_per_turn.empty()) {
    f.ripple_periods_per_turn = ripple_periods(top);
    if (!f.ripple_periods_per_turn.empty()) f.identified.insert("ripple_periods_per_turn");
  }
  const auto waiboer = [&](const char* name) {
    return number_at(top, {"friction", "waiboer", name, "motor", "estimate"});
  };
  taken.fill("stribeck_speed_rad_s", f.stribeck_speed_rad_s, waiboer("stribeck_speed_rad_s"));
  const auto at_rest = waiboer("asperity_torque_Nm");
  if (at_rest && *at_rest >= f.coulomb_Nm.value_or(0)) {
    taken.fill("static_Nm", f.static_Nm, at_rest);
  }
  taken.fill(
      "bristle_stiffness_Nm_rad", f.bristle_stiffness_Nm_rad,
      number_at(top, {"friction", "lugre", "bristle_stiffness_Nm_rad", "motor", "estimate"}));
  try {
    joint::check_joint_facts(f);
  } catch (const std::invalid_argument& error) {
    throw InputError({file, 0, 0},
                     {"does not go with the joint's file: " + wording::words(error), "", "", ""});
  }
  return f;
}

}  // namespace tribolog::ingest::manifest
