#pragma once
// Characters that no reader sees, or that a terminal or a page obeys instead of showing them.

namespace tribolog {

/// C0 with tab and line feed, DEL and C1.
constexpr bool is_control_character(char32_t c) { return c < 0x20 || (c >= 0x7f && c <= 0x9f); }

/// What turns the direction of text (U+061C, U+200E/F, U+202A to U+202E, U+2066 to U+2069), ends
/// lines unseen (U+2028/9), has no shape (U+00AD, U+180E, U+200B to U+200D, U+2060 to U+2065,
/// U+FEFF, annotations and tags), and non-characters.
constexpr bool is_hidden_character(char32_t c) {
  return c == 0x00AD || c == 0x061C || c == 0x180E || c == 0xFEFF || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) ||
         (c >= 0xFFF9 && c <= 0xFFFB) || (c >= 0xFDD0 && c <= 0xFDEF) || (c & 0xFFFEU) == 0xFFFEU ||
         (c >= 0xE0000 && c <= 0xE0FFF);
}

}  // namespace tribolog
