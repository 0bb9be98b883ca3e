#pragma once
// A small font with the glyphs of a few characters, for embedding into a document.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/vector/true_type_file.h"

namespace tribolog::render {

/// Glyphs are numbered anew: 0 is the sign for what is missing, then one for each character in the
/// order of their code points, then what these are composed of.
struct TrueTypeSubset {
  std::string bytes;                         ///< A whole font file, with a character map.
  std::map<char32_t, std::uint16_t> glyphs;  ///< By character.
};

/// @param characters with their glyphs in `font`
/// @param family under which the subset is known. Copyright and licence address stay in it.
/// Hinting is left out: nothing prints with it, and screens are fine enough. The same input gives
/// the same bytes.
/// @throw tribolog::FigureError if the font is damaged.
TrueTypeSubset true_type_subset(const TrueTypeFile& font,
                                const std::map<char32_t, unsigned>& characters,
                                const std::string& family);

}  // namespace tribolog::render
