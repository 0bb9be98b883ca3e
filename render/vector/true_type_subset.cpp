#include <algorithm>

#include "base/error.h"
#include "render/vector/true_type.h"

namespace tribolog::render::vector {

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
  if (points > outline.size()) throw FigureError({"drawing.glyph_cut_off"});
  std::string out(outline.substr(0, at));
  put_u16(out, 0);
  out += outline.substr(points);
  return out;
}

}  // namespace

SubsetGlyphs::SubsetGlyphs(const TrueTypeFile& font) : font_(font) { add(0); }

std::uint16_t SubsetGlyphs::add(unsigned original) {
  constexpr std::size_t most = 0xFFFF;
  if (originals_.size() >= most) throw FigureError({"drawing.too_many_characters"});
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
      throw FigureError({"drawing.composed_glyph_cut_off"});
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

namespace {

using Bytes = std::string;

std::uint32_t checksum(const Bytes& table) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    sum += static_cast<std::uint32_t>(static_cast<std::uint8_t>(table[i])) << (24U - 8U * (i % 4));
  }
  return sum;
}

/// The directory, then the tables, each padded to four bytes.
Bytes font_file(const std::map<std::string, Bytes>& tables) {
  const auto count = static_cast<std::uint16_t>(tables.size());
  std::uint16_t power = 1;
  std::uint16_t exponent = 0;
  while (power * 2 <= count) {
    power = static_cast<std::uint16_t>(power * 2);
    ++exponent;
  }
  Bytes out;
  put_u32(out, 0x00010000);
  put_u16(out, count);
  put_u16(out, static_cast<std::uint16_t>(power * 16));
  put_u16(out, exponent);
  put_u16(out, static_cast<std::uint16_t>((count - power) * 16));
  std::size_t offset = out.size() + 16UL * count;
  std::size_t head_at = 0;
  for (const auto& [tag, table] : tables) {
    if (tag == "head") head_at = offset;
    out += tag;
    put_u32(out, checksum(table));
    put_u32(out, static_cast<std::uint32_t>(offset));
    put_u32(out, static_cast<std::uint32_t>(table.size()));
    offset += (table.size() + 3) / 4 * 4;
  }
  for (const auto& [tag, table] : tables) {
    out += table;
    out.resize((out.size() + 3) / 4 * 4, '\0');
  }
  constexpr std::uint32_t wanted_sum = 0xB1B0AFBA;
  constexpr std::size_t adjustment = 8;
  Bytes difference;
  put_u32(difference, wanted_sum - checksum(out));
  out.replace(head_at + adjustment, 4, difference);
  return out;
}

}  // namespace

TrueTypeSubset true_type_subset(const TrueTypeFile& font,
                                const std::map<char32_t, unsigned>& characters,
                                const std::string& family) {
  TrueTypeSubset out;
  SubsetGlyphs glyphs(font);
  for (const auto& [character, id] : characters) {
    out.glyphs.emplace(character, glyphs.add(id));
  }
  const GlyphTables outlines = glyphs.tables();
  std::map<std::string, Bytes> tables;
  tables["glyf"] = outlines.glyf;
  tables["loca"] = outlines.loca;
  tables["hmtx"] = outlines.hmtx;
  tables["head"] = head_table(font);
  tables["hhea"] = hhea_table(font, glyphs.count());
  tables["maxp"] = maxp_table(font, glyphs.count());
  tables["cmap"] = cmap_table(out.glyphs);
  tables["name"] = name_table(font, family);
  tables["OS/2"] = os2_table(font, out.glyphs);
  tables["post"] = post_table(font);
  const Bytes kern = kern_table(font, glyphs.originals(), out.glyphs.size());
  if (!kern.empty()) tables["kern"] = kern;
  out.bytes = font_file(tables);
  return out;
}

}  // namespace tribolog::render::vector
