#include "render/text/text_line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "render/text/characters.h"

namespace tribolog::render::text {

namespace {

void append(std::vector<MarkupRun>& runs, std::u32string_view text, Shift shift) {
  if (text.empty()) return;
  if (runs.empty() || runs.back().shift != shift) runs.push_back({{}, shift});
  runs.back().text += text;
}

}  // namespace

MarkupText parse_markup(std::string_view utf8) {
  const DecodedText decoded = decode_utf8(utf8);
  MarkupText out;
  out.replaced = decoded.replaced;
  std::u32string_view rest = decoded.text;
  while (!rest.empty()) {
    const bool opens = rest.size() > 2 && (rest[0] == U'_' || rest[0] == U'^') && rest[1] == U'{';
    const std::size_t closing = opens ? rest.find(U'}', 2) : std::u32string_view::npos;
    if (closing == std::u32string_view::npos) {
      append(out.runs, rest.substr(0, 1), Shift::none);
      rest.remove_prefix(1);
      continue;
    }
    append(out.runs, rest.substr(2, closing - 2),
           rest[0] == U'_' ? Shift::subscript : Shift::superscript);
    rest.remove_prefix(closing + 1);
  }
  return out;
}

namespace {

constexpr double script_size = 0.70;
constexpr double superscript_raise = 0.36;  // of the full size
constexpr double subscript_drop = 0.17;
constexpr double capital_height = 0.73;  // DejaVu Sans
constexpr double letter_height = 0.55;   // its x-height; free-standing accents sit above it

class Shaper {
 public:
  Shaper(const Font& font, const TextStyle& style, TextFaults& faults)
      : font_(font), faults_(faults) {
    line_.style = style;
    line_.ascent = capital_height * style.size_px;
  }

  void add(const MarkupRun& run) {
    const bool script = run.shift != Shift::none;
    const int full = line_.style.size_px;
    piece_.size_px = script ? static_cast<int>(std::lround(script_size * full)) : full;
    piece_.raise = run.shift == Shift::superscript ? std::round(superscript_raise * full)
                   : run.shift == Shift::subscript ? -std::round(subscript_drop * full)
                                                   : 0.0;
    start_piece();
    for (const char32_t c : run.text) add(c);
    finish_piece();
  }

  TextLine take() {
    line_.width = pen_;
    return std::move(line_);
  }

 private:
  void add(char32_t c) {
    if (const auto sign = free_standing(c); sign && previous_ != 0) {
      add_accent(c, *sign);
      return;
    }
    if (!font_.has(line_.style.weight, c)) {
      faults_.without_glyph += c;
      c = U'?';
    }
    if (previous_ != 0) {
      pen_ += font_.kerning(line_.style.weight, piece_.size_px, previous_, c);
    }
    put(c);
  }

  void put(char32_t c) {
    const GlyphMeasure& glyph = measure(c);
    glyph_start_ = pen_;
    text_ += c;
    piece_.ink_top = std::max(piece_.ink_top, glyph.top);
    piece_.ink_bottom = std::min(piece_.ink_bottom, glyph.bottom);
    pen_ += glyph.advance;
    previous_ = c;
  }

  void add_accent(char32_t mark, char32_t sign) {
    if (const auto whole = composed(previous_, mark);
        whole && font_.has(line_.style.weight, *whole)) {
      text_.pop_back();
      pen_ = glyph_start_;
      put(*whole);
      return;
    }
    const GlyphMeasure letter = measure(previous_);
    const GlyphMeasure accent = measure(sign);
    const double above = std::max(0.0, letter.top - letter_height * piece_.size_px);
    TextPiece piece;
    piece.text = encode_utf8(std::u32string(1, sign));
    piece.size_px = piece_.size_px;
    piece.offset = glyph_start_ + (letter.left + letter.right - accent.left - accent.right) / 2;
    piece.raise = piece_.raise + std::round(above);
    piece.advance = accent.advance;
    piece.ink_top = accent.top;
    piece.ink_bottom = accent.bottom;
    accents_.push_back(std::move(piece));
  }

  void start_piece() {
    piece_.offset = pen_;
    piece_.ink_top = 0;
    piece_.ink_bottom = 0;
    previous_ = 0;
    text_.clear();
  }

  void finish_piece() {
    piece_.text = encode_utf8(text_);
    piece_.advance = pen_ - piece_.offset;
    keep(piece_);
    for (const TextPiece& accent : accents_) keep(accent);
    accents_.clear();
  }

  void keep(const TextPiece& piece) {
    if (piece.text.empty()) return;
    line_.ascent = std::max(line_.ascent, piece.raise + piece.ink_top);
    line_.descent = std::max(line_.descent, -(piece.raise + piece.ink_bottom));
    line_.pieces.push_back(piece);
  }

  [[nodiscard]] const GlyphMeasure& measure(char32_t c) const {
    return font_.measure(line_.style.weight, piece_.size_px, c);
  }

  const Font& font_;
  TextFaults& faults_;
  TextLine line_;
  TextPiece piece_;
  std::vector<TextPiece> accents_;
  std::u32string text_;
  char32_t previous_{};
  double glyph_start_{};
  double pen_{};
};

}  // namespace

TextLine shape_line(const Font& font, std::string_view markup, const TextStyle& style,
                    TextFaults& faults) {
  const MarkupText parsed = parse_markup(markup);
  faults.malformed += parsed.replaced;
  Shaper shaper(font, style, faults);
  for (const MarkupRun& run : parsed.runs) shaper.add(run);
  return shaper.take();
}

figure::PixelBox box_of_line(const TextLine& line, figure::PixelPoint start, bool upright) {
  const double x = std::round(start.x);
  const double y = std::round(start.y);
  if (upright) return {x, y - line.ascent, x + line.width, y + line.descent};
  return {x - line.ascent, y - line.width, x + line.descent, y};
}

figure::PixelBox place_line(figure::DrawList& list, const TextLine& line, figure::PixelPoint start,
                            bool upright, figure::Owner owner) {
  const double x = std::round(start.x);
  const double y = std::round(start.y);
  for (const TextPiece& piece : line.pieces) {
    figure::TextRun run{owner,
                        piece.text,
                        line.style.weight == Weight::bold,
                        piece.size_px,
                        {},
                        upright,
                        line.style.colour,
                        {}};
    const double along = std::round(piece.offset);
    if (upright) {
      run.baseline = {x + along, y - piece.raise};
      run.box = {run.baseline.x, run.baseline.y - piece.ink_top, run.baseline.x + piece.advance,
                 run.baseline.y - piece.ink_bottom};
    } else {
      run.baseline = {x - piece.raise, y - along};
      run.box = {run.baseline.x - piece.ink_top, run.baseline.y - piece.advance,
                 run.baseline.x - piece.ink_bottom, run.baseline.y};
    }
    list.primitives.emplace_back(std::move(run));
  }
  return box_of_line(line, start, upright);
}

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

}  // namespace tribolog::render::text
