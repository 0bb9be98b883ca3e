#include <cstddef>

#include "render/text/text_line.h"
#include "render/text/utf8.h"

namespace tribolog::render {
namespace {

/// Words in the markup; a space inside `_{...}` or `^{...}` does not divide.
std::vector<std::string> words_of(const std::string& markup) {
  std::vector<std::string> words(1);
  bool inside = false;
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    if (c == '{' && i > 0 && (markup[i - 1] == '_' || markup[i - 1] == '^')) {
      inside = markup.find('}', i) != std::string::npos;
    }
    if (c == '}') inside = false;
    if (!inside && (c == ' ' || c == '\n' || c == '\t')) {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// Whole characters that remain of the markup when its last one is dropped.
std::string without_last(const std::string& markup) {
  std::u32string text = decode_utf8(markup).text;
  text.pop_back();
  if (!text.empty() && text.back() == U'{') text.pop_back();
  return encode_utf8(text);
}

}  // namespace

std::vector<TextLine> wrap_lines(const Font& font, const std::string& markup,
                                 const TextStyle& style, double width, std::size_t most_lines,
                                 TextFaults& faults, bool& cut) {
  TextFaults trial;
  const auto fits = [&](const std::string& text) {
    return shape_line(font, text, style, trial).width <= width;
  };
  if (fits(markup)) return {shape_line(font, markup, style, faults)};

  std::vector<std::string> lines(1);
  for (const std::string& word : words_of(markup)) {
    std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || lines.size() == most_lines || fits(longer)) {
      lines.back() = std::move(longer);
    } else {
      lines.push_back(word);
    }
  }
  std::vector<TextLine> out;
  constexpr std::size_t longest = 1000;  // bytes; nothing longer fits into a picture
  for (std::string& line : lines) {
    if (line.size() > longest) line.resize(longest);
    std::string shown = line;
    while (!line.empty() && !fits(shown)) {
      line = without_last(line);
      shown = line + "…";
      cut = true;
    }
    out.push_back(shape_line(font, shown, style, faults));
  }
  return out;
}

}  // namespace tribolog::render
