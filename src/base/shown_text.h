#pragma once
// Numbers and names from outside as text that is safe where it goes. See printable() for the
// single name.

#include <charconv>
#include <string>
#include <string_view>

namespace tribolog {

/// Appends a finite number. No double needs more than 24 characters.
inline void append_number(std::string& text, double value) {
  char digits[32];
  const auto written = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, written.ptr);
}

// Whole texts with names from outside in them, made safe for where they go. See printable() for
// the single name.

/// Text of any number of lines for a terminal: what a terminal obeys or hides, but for line ends,
/// and bytes that are not UTF-8 become \x1b.
std::string lines_for_terminal(std::string_view text);

/// JSON in which no text holds a character as it is that a terminal obeys or hides: U+0085 becomes
/// \u0085, which reads back as the same. Bytes that are not UTF-8 become U+FFFD.
/// @param json what a JSON writer made: such characters stand in texts only.
std::string json_without_hidden(std::string json);

/// One word for a shell: as it is where that is safe, else in single quotes.
std::string quoted_for_shell(const std::string& word);

}  // namespace tribolog
