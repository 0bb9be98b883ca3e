// The joint of a calibration: what it adds to a joint's file, and what its recordings show of
// limits.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/arrays/json_text.h"
#include "ingest/manifest/joint_file.h"
#include "ingest/manifest/scenario_tables.h"
#include "ingest/manifest/toml_table.h"
#include "joint/degrees.h"
#include "wording/axis_scale.h"
#include "wording/words.h"

namespace tribolog::ingest::manifest {

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

std::string text_at(const arrays::JsonValue& top, std::initializer_list<const char*> path) {
  const arrays::JsonValue* value = at(top, path);
  const bool is_text = value != nullptr && value->kind == arrays::JsonKind::text;
  return is_text ? std::string(value->content->text) : std::string();
}

const std::vector<arrays::JsonValue>& list_at(const arrays::JsonValue& top,
                                              std::initializer_list<const char*> path) {
  static const std::vector<arrays::JsonValue> none;
  const arrays::JsonValue* value = at(top, path);
  const bool is_list = value != nullptr && value->kind == arrays::JsonKind::array;
  return is_list ? value->content->elements : none;
}

/// @throw InputError: it is no calibration.
arrays::JsonValue calibration_in(std::string_view text, const std::string& file) {
  arrays::JsonValue top = arrays::parse_json_text(text, file);
  if (text_at(top, {"schema"}) != "tribolog-calibration-1") {
    throw InputError({file, 0, 0}, {"is no calibration", "", "schema \"tribolog-calibration-1\"",
                                    "tribolog identify writes one"});
  }
  return top;
}

std::vector<double> ripple_periods(const arrays::JsonValue& top) {
  std::vector<double> periods;
  for (const arrays::JsonValue& line : list_at(top, {"ripple", "lines"})) {
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

/// @throw as with_calibration()
joint::JointFacts with_numbers(joint::JointFacts f, const arrays::JsonValue& top,
                               const std::string& file) {
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

}  // namespace

joint::JointFacts with_calibration(joint::JointFacts facts, std::string_view calibration,
                                   const std::string& file) {
  return with_numbers(std::move(facts), calibration_in(calibration, file), file);
}

namespace {

/// What the joint did in the recordings, motor side but for the angles.
struct Recorded {
  wording::Extent angle_rad;
  wording::Extent speed_rad_s;
  wording::Extent torque_Nm;
};

Recorded recorded_in(const arrays::JsonValue& top) {
  Recorded all;
  const auto take = [](wording::Extent& extent, const std::optional<double>& value) {
    if (value) extent.add(*value);
  };
  for (const char* sweep : {"rough", "precise"}) {
    take(all.angle_rad, number_at(top, {"cog", sweep, "lowest_rad"}));
    take(all.angle_rad, number_at(top, {"cog", sweep, "highest_rad"}));
    take(all.torque_Nm, number_at(top, {"cog", sweep, "argmax_torque_Nm"}));
  }
  for (const arrays::JsonValue& run : list_at(top, {"viscous", "runs"})) {
    take(all.angle_rad, number_at(run, {"lowest_rad"}));
    take(all.angle_rad, number_at(run, {"highest_rad"}));
    take(all.speed_rad_s, number_at(run, {"speed_rad_s"}));
    take(all.torque_Nm, number_at(run, {"torque_Nm"}));
  }
  for (const arrays::JsonValue& loop : list_at(top, {"hysteresis", "oscillations"})) {
    take(all.angle_rad, number_at(loop, {"centre_rad"}));
  }
  for (const arrays::JsonValue& one : list_at(top, {"friction_at_speed"})) {
    take(all.speed_rad_s, number_at(one, {"speed_rad_s"}));
  }
  take(all.torque_Nm, number_at(top, {"model", "top_Nm"}));
  return all;
}

/// Of the log of the most samples a second.
std::optional<double> sample_rate_in(const arrays::JsonValue& top) {
  std::optional<double> rate;
  for (const arrays::JsonValue& one : list_at(top, {"speeds"})) {
    const auto samples = number_at(one, {"window_samples"});
    const auto window_s = number_at(one, {"window_s"});
    if (!samples || !window_s || !(*window_s > 0)) continue;
    rate = std::max(rate.value_or(0), std::round(*samples / *window_s));
  }
  return rate && *rate > 0 ? rate : std::nullopt;
}

/// To three digits, as one states a limit.
double rounded(double value) {
  if (value == 0) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
  return std::round(value / unit) * unit;
}

[[noreturn]] void refuse_to_plan(const std::string& file, const std::string& lacks) {
  throw InputError({file, 0, 0},
                   {"shows no limits to plan within: " + lacks, "", "",
                    "state them in a joint's file, and give this one as --calibration"});
}

}  // namespace

joint::JointFacts recorded_joint(std::string_view calibration, const std::string& file) {
  constexpr double time_to_speed_s = 0.2;  // in which the fastest speed is reached
  constexpr double spare_torque = 1.3;     // for what no plateau shows: acceleration
  const arrays::JsonValue top = calibration_in(calibration, file);
  if (number_at(top, {"drive", "torque_is_in_amperes"}).value_or(0) != 0) {
    refuse_to_plan(file, "its torques are in ampere");
  }
  const Recorded recorded = recorded_in(top);
  if (!(recorded.angle_rad.span() > 0)) {
    refuse_to_plan(file, "neither a sweep nor a run at constant speed was recorded");
  }
  const double speed_rad_s = recorded.speed_rad_s.largest();
  const double torque_Nm = recorded.torque_Nm.largest();
  if (!(speed_rad_s > 0 && torque_Nm > 0)) {
    refuse_to_plan(file, "no friction was found at any speed");
  }
  joint::JointFacts f;
  f.robot = text_at(top, {"robot", "name"});
  f.serial = text_at(top, {"robot", "serial"});
  f.joint = text_at(top, {"robot", "joint"});
  f.gear_ratio = std::abs(number_at(top, {"drive", "gear_ratio"}).value_or(1));
  const auto in_degrees = [](double rad) {
    return rounded(rad * joint::degrees_per_rad) * joint::rad_per_degree;
  };
  f.lowest_rad = in_degrees(recorded.angle_rad.low);
  const double one_turn = recorded.angle_rad.low + 2 * std::numbers::pi;  // gravity repeats
  f.highest_rad = in_degrees(std::min(recorded.angle_rad.high, one_turn));
  f.speed_limit_rad_s = in_degrees(speed_rad_s / f.gear_ratio);
  f.acceleration_limit_rad_s2 = in_degrees(f.speed_limit_rad_s / time_to_speed_s);
  f.torque_limit_Nm = rounded(spare_torque * torque_Nm);
  f.sample_rate_Hz = sample_rate_in(top);
  for (const arrays::JsonValue& loop : list_at(top, {"hysteresis", "oscillations"})) {
    const auto step_rad = number_at(loop, {"encoder_step_rad"});
    if (!step_rad || !(*step_rad > 0)) continue;
    f.encoder_counts_per_turn = std::round(2 * std::numbers::pi / (*step_rad * f.gear_ratio));
  }
  for (const joint::EffortKind kind :
       {joint::EffortKind::motor_current, joint::EffortKind::joint_torque}) {
    if (text_at(top, {"drive", "effort_kind"}) == to_string(kind)) f.effort_kind = kind;
  }
  if (text_at(top, {"drive", "effort_side"}) == to_string(joint::Side::joint)) {
    f.effort_side = joint::Side::joint;
  }
  f.torque_constant_Nm_A = number_at(top, {"drive", "torque_constant_Nm_A"});
  return with_numbers(std::move(f), top, file);
}

}  // namespace tribolog::ingest::manifest
