#pragma once
// One line of text with sub- and superscripts, measured and ready to be placed.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/text/font.h"

namespace tribolog::render::text {

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

struct TextStyle {
  int size_px{26};
  Weight weight{Weight::regular};
  figure::Colour colour{30, 30, 30};
};

/// Runs relative to the start of the baseline; `raise` is upwards.
struct TextPiece {
  std::string text;
  int size_px{};
  double offset{};
  double raise{};
  double advance{};
  double ink_top{};     ///< Above this piece's own baseline.
  double ink_bottom{};  ///< Negative below it.
};

struct TextLine {
  std::vector<TextPiece> pieces;
  TextStyle style;
  double width{};
  double ascent{};   ///< Highest ink above the baseline, at least a capital's height.
  double descent{};  ///< Lowest ink below it, as a positive number.
  [[nodiscard]] double height() const { return ascent + descent; }
  [[nodiscard]] bool empty() const { return pieces.empty(); }
};

/// Collects what could not be printed as it was given.
struct TextFaults {
  std::size_t malformed{};
  std::u32string without_glyph;
};

/// A character without a glyph becomes '?' and is noted. Kerning and advances are those that VTK
/// uses, per piece.
TextLine shape_line(const Font& font, std::string_view markup, const TextStyle& style,
                    TextFaults& faults);

/// Breaks between words so that no line is wider than `width`; at most `most_lines`, the last one
/// cut with an ellipsis where needed (`cut` is then set).
std::vector<TextLine> wrap_lines(const Font& font, const std::string& markup,
                                 const TextStyle& style, double width, std::size_t most_lines,
                                 TextFaults& faults, bool& cut);

/// Puts a line with the start of its baseline at `start`, rounded to whole pixels; from bottom to
/// top if not `upright`. Returns the box that it takes.
figure::PixelBox place_line(figure::DrawList& list, const TextLine& line, figure::PixelPoint start,
                            bool upright, figure::Owner owner);

/// The box that place_line would return.
figure::PixelBox box_of_line(const TextLine& line, figure::PixelPoint start, bool upright);

}  // namespace tribolog::render::text
