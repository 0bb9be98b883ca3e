#pragma once
// Whole texts with names from outside in them, made safe for where they go. See printable() for
// the single name.

#include <string>
#include <string_view>

namespace tribolog {

/// Text of any number of lines for a terminal: what a terminal obeys or hides, but for line ends,
/// and bytes that are not UTF-8 become \x1b.
std::string lines_for_terminal(std::string_view text);

/// JSON in which no text holds a character as it is that a terminal obeys or hides: U+0085 becomes
/// \u0085, which reads back as the same. Bytes that are not UTF-8 become U+FFFD.
/// @param json what a JSON writer made: such characters stand in texts only.
std::string json_without_hidden(std::string json);

}  // namespace tribolog
