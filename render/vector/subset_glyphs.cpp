#include "render/vector/subset_glyphs.h"

#include <algorithm>

#include "base/error.h"
#include "render/vector/subset_tables.h"

namespace tribolog::render {
namespace {

// Flags of a component of a composed glyph.
constexpr unsigned words = 0x0001;
constexpr unsigned scale = 0x0008;
constexpr unsigned more = 0x0020;
constexpr unsigned two_scales = 0x0040;
constexpr unsigned matrix = 0x0080;
constexpr unsigned instructions = 0x0100;

constexpr std::size_t header_size = 10;

std::size_t arguments_size(unsigned flags) {
  std::size_t size = (flags & words) != 0 ? 4 : 2;
  if ((flags & scale) != 0) size += 2;
  if ((flags & two_scales) != 0) size += 4;
  if ((flags & matrix) != 0) size += 8;
  return size;
}

/// A glyph of contours: the header, where each contour ends, no instructions, the points.
std::string without_instructions(std::string_view outline, int contours) {
  const std::size_t at = header_size + 2 * static_cast<std::size_t>(contours);
  const std::size_t points = at + 2 + u16_at(outline, at);
  if (points > outline.size()) throw FigureError("a font file is damaged: a glyph is cut off");
  std::string out(outline.substr(0, at));
  put_u16(out, 0);
  out += outline.substr(points);
  return out;
}

}  // namespace

SubsetGlyphs::SubsetGlyphs(const TrueTypeFile& font) : font_(font) { add(0); }

std::uint16_t SubsetGlyphs::add(unsigned original) {
  constexpr std::size_t most = 0xFFFF;
  if (originals_.size() >= most) throw FigureError("a figure has too many different characters");
  originals_.push_back(original);
  return static_cast<std::uint16_t>(originals_.size() - 1);
}

std::uint16_t SubsetGlyphs::number_of(unsigned original) {
  const auto known = std::find(originals_.begin(), originals_.end(), original);
  if (known != originals_.end()) return static_cast<std::uint16_t>(known - originals_.begin());
  return add(original);
}

std::string SubsetGlyphs::composed(std::string_view outline) {
  std::string out(outline.substr(0, header_size));
  std::size_t at = header_size;
  for (unsigned flags = more; (flags & more) != 0;) {
    flags = u16_at(outline, at);
    const std::size_t arguments = arguments_size(flags);
    put_u16(out, static_cast<std::uint16_t>(flags & ~instructions));
    put_u16(out, number_of(u16_at(outline, at + 2)));
    if (at + 4 + arguments > outline.size()) {
      throw FigureError("a font file is damaged: a composed glyph is cut off");
    }
    out += outline.substr(at + 4, arguments);
    at += 4 + arguments;
  }
  return out;
}

std::string SubsetGlyphs::rewritten(std::string_view outline) {
  if (outline.empty()) return {};
  const int contours = i16_at(outline, 0);
  return contours < 0 ? composed(outline) : without_instructions(outline, contours);
}

GlyphTables SubsetGlyphs::tables() {
  GlyphTables out;
  put_u32(out.loca, 0);
  for (std::size_t i = 0; i < originals_.size(); ++i) {  // grows while composed glyphs are met
    const unsigned original = originals_[i];
    out.glyf += rewritten(font_.glyph(original));
    out.glyf.resize((out.glyf.size() + 3) / 4 * 4, '\0');
    put_u32(out.loca, static_cast<std::uint32_t>(out.glyf.size()));
    put_u16(out.hmtx, font_.advance(original));
    put_u16(out.hmtx, static_cast<std::uint16_t>(font_.left_side_bearing(original)));
  }
  return out;
}

}  // namespace tribolog::render
