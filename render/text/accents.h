#pragma once
// Letters with a combining mark, as mechanics writes them: q with a dot, theta with a hat.

#include <optional>
#include <string>
#include <string_view>

namespace tribolog::render::text {

/// The one code point that stands for letter and mark ("z" + U+0307 -> U+017C), if Unicode has one
/// among the letters that figures use.
std::optional<char32_t> composed(char32_t letter, char32_t mark);

/// The free-standing sign that looks like a combining mark (U+0307 -> U+02D9), to be placed above
/// the letter; nothing for a character that is no such mark.
std::optional<char32_t> free_standing(char32_t mark);

}  // namespace tribolog::render::text
