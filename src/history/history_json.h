#pragma once
// Comparisons, trends and fleets as JSON for scripts.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "history/comparison.h"
#include "history/fleet.h"
#include "history/joint_trend.h"
#include "statistics/estimate.h"

namespace tribolog::history {

using OrderedJson = nlohmann::ordered_json;

inline OrderedJson json_of(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? OrderedJson(*value) : OrderedJson();
}

inline OrderedJson json_of(const statistics::Estimate& e) {
  return {{"estimate", json_of(std::optional(e.value))},
          {"low", json_of(std::optional(e.low))},
          {"high", json_of(std::optional(e.high))}};
}

inline OrderedJson json_of(const std::optional<statistics::Estimate>& e) {
  return e ? json_of(*e) : OrderedJson();
}

/// Bytes that are no UTF-8 become the replacement character.
inline std::string text_of(const OrderedJson& json) {
  return json_without_hidden(json.dump(2, ' ', false, OrderedJson::error_handler_t::replace)) +
         "\n";
}

// A comparison as JSON for scripts.

/// Schema "tribolog-archive-diff-1": SI, motor side. The same comparison gives the same bytes.
std::string comparison_json(const Comparison& comparison);

// Trends as JSON for scripts.

/// Schema "tribolog-archive-trend-1": SI, motor side. The same trends give the same bytes.
std::string trend_json(const std::vector<JointTrend>& trends);

// The fleet sheet for scripts.

/// {"schema": "tribolog-fleet-1", "limit", "robots": [{"joints": [{"quantities": [...]}]}]}: the
/// latest result of each quantity (SI, motor side) with both distances; the furthest robot first.
std::string fleet_json(const Fleet& fleet);

}  // namespace tribolog::history
