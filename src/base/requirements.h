#pragma once
// What has to hold: a value that is there, parameters that are possible.

#include <optional>
#include <stdexcept>
#include <utility>

namespace tribolog {

/// For where an invariant, and no test nearby, says that there is a value. Without one the program
/// says that it is at fault, instead of going on with a number that nobody has measured.
/// @throw std::logic_error where there is none.
template <class T>
const T& present(const std::optional<T>& value) {
  if (!value) throw std::logic_error("a value is missing that has to be there");
  return *value;
}

template <class T>
T& present(std::optional<T>& value) {
  if (!value) throw std::logic_error("a value is missing that has to be there");
  return *value;
}

template <class T>
T present(std::optional<T>&& value) {
  if (!value) throw std::logic_error("a value is missing that has to be there");
  return *std::move(value);
}

// Rules that physical parameters obey, with one wording for what breaks them.

/// @throw std::invalid_argument "<what> <value> <unit> is not allowed; it must be > 0"
void require_positive(double value, const char* what, const char* unit);

/// @throw std::invalid_argument "<what> <value> <unit> is not allowed; it must be >= 0"
void require_not_negative(double value, const char* what, const char* unit);

/// @throw std::invalid_argument "<lower> <value> <unit> exceeds <upper> <value> <unit>; it must not
/// be larger"
void require_not_above(double value, const char* lower, double bound, const char* upper,
                       const char* unit);

}  // namespace tribolog
