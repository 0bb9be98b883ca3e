#pragma once
// Internal to the history: what its JSON files have in common.

#include <cmath>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "base/shown_text.h"
#include "statistics/estimate.h"

namespace tribolog::history {

using OrderedJson = nlohmann::ordered_json;

inline OrderedJson json_of(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? OrderedJson(*value) : OrderedJson();
}

inline OrderedJson json_of(const Estimate& e) {
  return {{"estimate", json_of(std::optional(e.value))},
          {"low", json_of(std::optional(e.low))},
          {"high", json_of(std::optional(e.high))}};
}

inline OrderedJson json_of(const std::optional<Estimate>& e) {
  return e ? json_of(*e) : OrderedJson();
}

/// Bytes that are no UTF-8 become the replacement character.
inline std::string text_of(const OrderedJson& json) {
  return json_without_hidden(json.dump(2, ' ', false, OrderedJson::error_handler_t::replace)) +
         "\n";
}

}  // namespace tribolog::history
