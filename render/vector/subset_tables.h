#pragma once
// The tables of a subset besides its outlines. Formats: OpenType specification.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/vector/true_type_file.h"

namespace tribolog::render::vector {

void put_u16(std::string& out, std::uint16_t value);
void put_u32(std::string& out, std::uint32_t value);

/// The number of each character's glyph in the subset. Neighbouring characters have neighbouring
/// numbers, which keeps the character map short.
using GlyphNumbers = std::map<char32_t, std::uint16_t>;

std::string head_table(const TrueTypeFile& font);
std::string hhea_table(const TrueTypeFile& font, std::uint16_t glyphs);
std::string maxp_table(const TrueTypeFile& font, std::uint16_t glyphs);
std::string cmap_table(const GlyphNumbers& glyphs);
std::string name_table(const TrueTypeFile& font, const std::string& family);
std::string os2_table(const TrueTypeFile& font, const GlyphNumbers& glyphs);
std::string post_table(const TrueTypeFile& font);
/// Of the first `characters` glyphs behind number 0; empty if no two of them are kerned.
/// @param originals the number in the font of each glyph of the subset
std::string kern_table(const TrueTypeFile& font, const std::vector<unsigned>& originals,
                       std::size_t characters);

}  // namespace tribolog::render::vector
