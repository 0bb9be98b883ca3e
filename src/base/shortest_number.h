#pragma once
// Numbers as text: the shortest that reads back to the same double, under every locale.

#include <charconv>
#include <string>

namespace tribolog {

/// Appends a finite number. No double needs more than 24 characters.
inline void append_number(std::string& text, double value) {
  char digits[32];
  const auto written = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, written.ptr);
}

}  // namespace tribolog
