#pragma once
// A value of a table, and rows of them.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tribolog::sql {

/// Bytes that are no text.
struct Blob {
  std::string bytes;
};

class Value {
 public:
  Value() = default;  ///< NULL
  Value(std::int64_t number) : value_(number) {}
  Value(double number) : value_(number) {}
  Value(std::string text) : value_(std::move(text)) {}
  Value(const char* text) : value_(std::string(text)) {}
  Value(Blob blob) : value_(std::move(blob)) {}
  /// NULL where absent.
  Value(const std::optional<double>& number) {
    if (number) value_ = *number;
  }

  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
  /// @throw std::bad_variant_access if it is none; so do the next ones.
  [[nodiscard]] std::int64_t integer() const { return std::get<std::int64_t>(value_); }
  /// Also of an integer.
  [[nodiscard]] double number() const {
    const auto* whole = std::get_if<std::int64_t>(&value_);
    return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value_);
  }
  [[nodiscard]] std::optional<double> number_if_any() const {
    return is_null() ? std::nullopt : std::optional(number());
  }
  [[nodiscard]] const std::string& text() const { return std::get<std::string>(value_); }
  [[nodiscard]] const std::string& bytes() const { return std::get<Blob>(value_).bytes; }

  [[nodiscard]] const auto& content() const { return value_; }

 private:
  std::variant<std::monostate, std::int64_t, double, std::string, Blob> value_;
};

using Row = std::vector<Value>;
using Rows = std::vector<Row>;

}  // namespace tribolog::sql
