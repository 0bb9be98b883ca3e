#pragma once
// Characters: UTF-8 that may be broken to code points and back, and letters with a combining mark.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tribolog::render::text {

struct DecodedText {
  std::u32string text;
  std::size_t replaced{};  ///< Malformed sequences and control characters, each shown as '?'.
};

/// Never fails: what is not a Unicode scalar value (overlong, surrogate, cut off) becomes '?', so
/// do control characters; tab and line break become a space.
DecodedText decode_utf8(std::string_view bytes);

std::string encode_utf8(std::u32string_view text);

// Letters with a combining mark, as mechanics writes them: q with a dot, theta with a hat.

/// The one code point that stands for letter and mark ("z" + U+0307 -> U+017C), if Unicode has one
/// among the letters that figures use.
std::optional<char32_t> composed(char32_t letter, char32_t mark);

/// The free-standing sign that looks like a combining mark (U+0307 -> U+02D9), to be placed above
/// the letter; nothing for a character that is no such mark.
std::optional<char32_t> free_standing(char32_t mark);

}  // namespace tribolog::render::text
