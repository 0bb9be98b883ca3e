#pragma once
// A font file in the TrueType format, read as far as a subset of it needs.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

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

}  // namespace tribolog::render::vector
