#pragma once
// Internal to calibration.json: numbers, texts and intervals as JSON. What is not finite or not
// known is null.

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "statistics/estimate.h"

namespace tribolog::json {

using Json = nlohmann::ordered_json;

Json number(double value);
Json number(const std::optional<double>& value);
Json numbers(const std::vector<double>& values);
/// Rounded to six significant digits: long lists that are drawn and not computed with.
Json short_numbers(const std::vector<double>& values);
Json text_or_null(const std::string& text);
/// {"estimate", "low", "high", "method"}
Json interval(const Estimate& e);
Json interval(const std::optional<Estimate>& e);
Json interval_if(bool is_known, const Estimate& e);
/// The same on both sides of the gear.
Json both_sides(const Estimate& motor, double motor_to_joint);

}  // namespace tribolog::json
