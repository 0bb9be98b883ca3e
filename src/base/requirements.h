#pragma once
// What has to hold: a value that is there, parameters that are possible.

#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/statement.h"

namespace tribolog {

/// For where an invariant, and no test nearby, says that there is a value. Without one the program
/// says that it is at fault, instead of going on with a number that nobody has measured.
/// @throw std::logic_error where there is none.
template <class T>
const T& present(const std::optional<T>& value) {
  if (!value) throw std::logic_error("missing value");
  return *value;
}

template <class T>
T& present(std::optional<T>& value) {
  if (!value) throw std::logic_error("missing value");
  return *value;
}

template <class T>
T present(std::optional<T>&& value) {
  if (!value) throw std::logic_error("missing value");
  return *std::move(value);
}

// Rules that physical parameters obey, with one message for what breaks them.

/// What a refusal calls a parameter: by its short name, "static torque", or its key in a file; a
/// code where its name takes more words.
class ParameterName {
 public:
  ParameterName(const char* name) : name_(name) {}  // NOLINT
  ParameterName(Code words) : words_(words) {}      // NOLINT
  /// @param value the value's name in the message.
  [[nodiscard]] StatedValue stated_as(std::string_view value) const;

 private:
  const char* name_{""};
  Code words_;
};

/// @throw Refusal "requirement.positive", or "requirement.positive_number" for an empty unit.
void require_positive(double value, const ParameterName& what, const char* unit);

/// @throw Refusal "requirement.not_negative", or "requirement.not_negative_number" for an empty
/// unit.
void require_not_negative(double value, const ParameterName& what, const char* unit);

/// @throw Refusal "requirement.not_above".
void require_not_above(double value, const ParameterName& lower, double bound,
                       const ParameterName& upper, const char* unit);

}  // namespace tribolog
