#include "calibration/json_values.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "wording/words.h"

namespace tribolog::calibration {

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

Json short_numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) {
    const std::string text = fmt::format("{:.6g}", value);
    double rounded = value;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    list.push_back(number(rounded));
  }
  return list;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json code_of(const Statement& statement) {
  if (statement.empty()) return nullptr;
  if (statement.values().empty()) return statement.code().text();
  Json values = Json::object();
  for (const StatedValue& one : statement.values()) {
    if (const auto* size = std::get_if<double>(&one.value)) {
      values[one.name] = number(*size);
    } else if (const auto* count = std::get_if<std::int64_t>(&one.value)) {
      values[one.name] = *count;
    } else if (const auto* name = std::get_if<std::string>(&one.value)) {
      values[one.name] = *name;
    } else {
      values[one.name] = code_of(std::get<std::vector<Statement>>(one.value));
    }
  }
  return {{"code", statement.code().text()}, {"values", std::move(values)}};
}

Json code_of(const std::vector<Statement>& statements) {
  Json list = Json::array();
  for (const Statement& one : statements) list.push_back(code_of(one));
  return list;
}

Json interval(const statistics::Estimate& e) {
  if (!std::isfinite(e.value)) return nullptr;
  return {{"estimate", e.value},
          {"low", number(e.low)},
          {"high", number(e.high)},
          {"method", wording::words(e.method)},
          {"method_code", code_of(e.method)}};
}

Json interval(const std::optional<statistics::Estimate>& e) {
  return e ? interval(*e) : Json(nullptr);
}

/// The same on both sides of the gear.
Json both_sides(const statistics::Estimate& motor, double motor_to_joint) {
  return {{"motor", interval(motor)},
          {"joint", interval(statistics::scaled(motor, motor_to_joint))}};
}

}  // namespace tribolog::calibration
