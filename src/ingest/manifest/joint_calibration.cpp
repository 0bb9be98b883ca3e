// What an earlier calibration tells a plan.

#include <cmath>
#include <initializer_list>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/arrays/json_text.h"
#include "ingest/manifest/joint_file.h"
#include "ingest/manifest/key_ranges.h"

namespace tribolog {
namespace {

const JsonValue* member(const JsonValue* object, std::string_view key) {
  if (object == nullptr || object->kind != JsonKind::object) return nullptr;
  for (std::size_t i = 0; i < object->content->keys.size(); ++i) {
    if (object->content->keys[i] == key) return &object->content->elements[i];
  }
  return nullptr;
}

const JsonValue* at(const JsonValue& top, std::initializer_list<const char*> path) {
  const JsonValue* value = &top;
  for (const char* key : path) value = member(value, key);
  return value;
}

std::optional<double> number_at(const JsonValue& top, std::initializer_list<const char*> path) {
  const JsonValue* value = at(top, path);
  if (value == nullptr || value->kind != JsonKind::number) return std::nullopt;
  return value->number;
}

std::vector<double> ripple_periods(const JsonValue& top) {
  std::vector<double> periods;
  const JsonValue* lines = at(top, {"ripple", "lines"});
  if (lines == nullptr || lines->kind != JsonKind::array) return periods;
  for (const JsonValue& line : lines->content->elements) {
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
  Taken(JointFacts& facts, const std::string& file) : facts_(facts), file_(file) {}

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
  JointFacts& facts_;
  const std::string& file_;
};

}  // namespace

JointFacts with_calibration(JointFacts f, std::string_view calibration, const std::string& file) {
  const JsonValue top = parse_json_text(calibration, file);
  const JsonValue* schema = at(top, {"schema"});
  if (schema == nullptr || schema->kind != JsonKind::text ||
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
    check_joint_facts(f);
  } catch (const std::invalid_argument& error) {
    throw InputError(
        {file, 0, 0},
        {std::string("does not go with the joint's file: ") + error.what(), "", "", ""});
  }
  return f;
}

}  // namespace tribolog
