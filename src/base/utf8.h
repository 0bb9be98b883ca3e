#pragma once
// UTF-8 as bytes: one character at a time, where it is broken, and what no reader sees of it.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tribolog {

struct Utf8Character {
  char32_t code_point{};
  std::size_t bytes{};  ///< 1 to 4; 0: the text does not start with a well-formed character.
};

/// The character at the start of a text. Overlong forms, surrogates and code points above U+10FFFF
/// are not well-formed.
constexpr Utf8Character first_utf8_character(std::string_view text) {
  if (text.empty()) return {};
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {};
  char32_t code_point = lead & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return {};
    code_point = (code_point << 6) | (byte(i) & 0x3fU);
  }
  const bool is_overlong =
      (bytes == 3 && code_point < 0x800) || (bytes == 4 && code_point < 0x10000);
  const bool is_surrogate = code_point >= 0xd800 && code_point <= 0xdfff;
  if (is_overlong || is_surrogate || code_point > 0x10ffff) return {};
  return {code_point, bytes};
}

/// Offset of the first byte that is not part of a well-formed character.
constexpr std::optional<std::size_t> first_broken_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = first_utf8_character(text.substr(i)).bytes;
    if (bytes == 0) return i;
    i += bytes;
  }
  return std::nullopt;
}

/// A character's bytes; none of what is no character (a surrogate, or beyond U+10FFFF).
inline std::string utf8_of(char32_t code_point) {
  const auto continued = [&](unsigned bits) {
    return static_cast<char>(0x80U | ((code_point >> bits) & 0x3FU));
  };
  const auto first = [&](unsigned mark, unsigned bits) {
    return static_cast<char>(mark | (code_point >> bits));
  };
  if (code_point < 0x80) return {first(0, 0)};
  if (code_point < 0x800) return {first(0xC0, 6), continued(0)};
  if (code_point >= 0xd800 && code_point <= 0xdfff) return {};
  if (code_point < 0x10000) return {first(0xE0, 12), continued(6), continued(0)};
  if (code_point > 0x10ffff) return {};
  return {first(0xF0, 18), continued(12), continued(6), continued(0)};
}

/// Every byte of Latin-1 is the code point of its character.
inline std::string utf8_of_latin1(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) text += utf8_of(static_cast<unsigned char>(byte));
  return text;
}

// Characters that no reader sees, or that a terminal or a page obeys instead of showing them.

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
