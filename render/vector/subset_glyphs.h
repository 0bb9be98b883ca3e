#pragma once
// The outlines of a subset, numbered anew.

#include <cstdint>
#include <string>
#include <vector>

#include "render/vector/true_type_file.h"

namespace tribolog::render {

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

}  // namespace tribolog::render
