#pragma once
// A value of a table, and rows of them.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.h"

namespace tribolog::sql {

/// Bytes that are no text.
struct Blob {
  std::string bytes;
  bool operator==(const Blob&) const = default;
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
  /// @throw ArchiveError if it is none, as in a damaged archive; so do the next ones.
  [[nodiscard]] std::int64_t integer() const { return as<std::int64_t>("a whole number"); }
  /// Also of an integer.
  [[nodiscard]] double number() const {
    const auto* whole = std::get_if<std::int64_t>(&value_);
    return whole != nullptr ? static_cast<double>(*whole) : as<double>("a number");
  }
  [[nodiscard]] std::optional<double> number_if_any() const {
    return is_null() ? std::nullopt : std::optional(number());
  }
  [[nodiscard]] const std::string& text() const { return as<std::string>("a text"); }
  [[nodiscard]] const std::string& bytes() const { return as<Blob>("a document's bytes").bytes; }

  [[nodiscard]] const auto& content() const { return value_; }
  bool operator==(const Value&) const = default;

 private:
  template <class Type>
  [[nodiscard]] const Type& as(const char* what) const {
    if (const auto* content = std::get_if<Type>(&value_)) return *content;
    throw ArchiveError(std::string("the archive is damaged (another value stands where ") + what +
                       " belongs); it is left as it is; restore a backup");
  }

  std::variant<std::monostate, std::int64_t, double, std::string, Blob> value_;
};

using Row = std::vector<Value>;
using Rows = std::vector<Row>;

}  // namespace tribolog::sql
