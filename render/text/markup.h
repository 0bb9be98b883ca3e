#pragma once
// The markup of figure texts: `_{...}` subscript, `^{...}` superscript, not nested.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::render {

enum class Shift { none, subscript, superscript };

struct MarkupRun {
  std::u32string text;
  Shift shift{Shift::none};
};

struct MarkupText {
  std::vector<MarkupRun> runs;
  std::size_t replaced{};  ///< See DecodedText.
};

/// Splits a text into runs. Braces that do not close are printed as they are.
MarkupText parse_markup(std::string_view utf8);

}  // namespace tribolog::render
