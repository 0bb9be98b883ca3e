#pragma once
// The value of an optional that has to hold one here.

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

}  // namespace tribolog
