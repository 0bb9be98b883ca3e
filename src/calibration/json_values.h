#pragma once
// Writes numbers, texts and intervals as JSON, and reads them back from files of any age.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "statistics/estimate.h"

namespace tribolog::calibration {

using Json = nlohmann::ordered_json;

Json number(double value);
Json number(const std::optional<double>& value);
Json numbers(const std::vector<double>& values);
/// Rounded to six significant digits: for long lists that are drawn, not computed with.
Json short_numbers(const std::vector<double>& values);
Json text_or_null(const std::string& text);
/// The machine-readable form beside the words: "topic.code", or {"code", "values"} where it has
/// some.
Json code_of(const Statement& statement);
Json code_of(const std::vector<Statement>& statements);
/// {"estimate", "low", "high", "method"}
Json interval(const statistics::Estimate& e);
Json interval(const std::optional<statistics::Estimate>& e);
/// The same on both sides of the gear.
Json both_sides(const statistics::Estimate& motor, double motor_to_joint);

// Reading the JSON of a calibration of any age: what an older program did not write is null.

/// The member of that name; null where there is none, and where `object` is no object.
inline const nlohmann::json& member(const nlohmann::json& object, std::string_view key) {
  static const nlohmann::json none;
  if (!object.is_object()) return none;
  const auto at = object.find(key);
  return at == object.end() ? none : *at;
}

}  // namespace tribolog::calibration
