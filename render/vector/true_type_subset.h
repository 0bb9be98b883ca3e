#pragma once
// A small font with the glyphs of a few characters, for embedding into a document.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "render/vector/true_type_file.h"

namespace tribolog::render::vector {

struct GlyphTables {
  std::string glyf;
  std::string loca;  ///< In the long format.
  std::string hmtx;
};

class SubsetGlyphs {
 public:
  /// Begins with the glyph for what is missing, number 0.
  explicit SubsetGlyphs(const TrueTypeFile& font);

  /// Another glyph of the font, by its number there; the number that it has here. One glyph may be
  /// added twice: each character has one of its own.
  std::uint16_t add(unsigned original);

  /// Adds what composed glyphs consist of, and writes all of it without hinting.
  /// @throw tribolog::FigureError if an outline is damaged.
  GlyphTables tables();

  [[nodiscard]] std::uint16_t count() const {
    return static_cast<std::uint16_t>(originals_.size());
  }
  /// The number in the font of each glyph.
  [[nodiscard]] const std::vector<unsigned>& originals() const { return originals_; }

 private:
  std::string rewritten(std::string_view outline);
  std::string composed(std::string_view outline);
  std::uint16_t number_of(unsigned original);

  const TrueTypeFile& font_;
  std::vector<unsigned> originals_;
};

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

}  // namespace tribolog::render::vector
