#pragma once
// Fonts in the TrueType format: a file, read as far as a subset of it needs, and the subset that a
// document carries. Formats: OpenType specification.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tribolog::render::vector {

/// Numbers in a font are big-endian. @throw tribolog::FigureError beyond the end of the bytes.
std::uint16_t u16_at(std::string_view bytes, std::size_t at);
std::int16_t i16_at(std::string_view bytes, std::size_t at);
std::uint32_t u32_at(std::string_view bytes, std::size_t at);

/// Lengths are in font units, `units_per_em` to the em.
class TrueTypeFile {
 public:
  /// @throw tribolog::FigureError if the file cannot be read, has no TrueType outlines, is cut off,
  /// or forbids being embedded; names the file.
  explicit TrueTypeFile(const std::string& path);

  /// @throw tribolog::FigureError if there is no such table.
  [[nodiscard]] std::string_view table(const std::string& tag) const;
  [[nodiscard]] bool has(const std::string& tag) const { return tables_.count(tag) > 0; }

  [[nodiscard]] int units_per_em() const { return units_per_em_; }
  [[nodiscard]] unsigned glyph_count() const { return glyph_count_; }
  /// Outline as it stands in the table `glyf`; empty for a space. @throw tribolog::FigureError for
  /// a glyph that the font has not.
  [[nodiscard]] std::string_view glyph(unsigned id) const;
  [[nodiscard]] std::uint16_t advance(unsigned id) const;
  [[nodiscard]] std::int16_t left_side_bearing(unsigned id) const;
  /// What to add between two glyphs; 0 for most.
  [[nodiscard]] int kerning(unsigned left, unsigned right) const;

 private:
  void read_directory();
  void read_kerning();

  std::string path_;
  std::string bytes_;
  std::map<std::string, std::string_view> tables_;
  std::map<std::uint32_t, int> kerning_;  ///< By left << 16 | right.
  int units_per_em_{};
  unsigned glyph_count_{};
  unsigned metric_count_{};
  bool long_offsets_{};
};

// The tables of a subset besides its outlines.

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

// A small font with the glyphs of a few characters, for embedding into a document.

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
