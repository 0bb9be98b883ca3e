#pragma once
// DejaVu Sans and its measures, straight from FreeType, so that layout needs no graphics.

#include <memory>
#include <string>

namespace tribolog::render::text {

enum class Weight { regular, bold };

/// In pixels, hinted as VTK draws it. `top` and `bottom` are the ink's reach above the baseline.
struct GlyphMeasure {
  double advance{};
  double left{};
  double right{};
  double top{};
  double bottom{};
};

/// Both weights of the font. Not thread-safe: measures are kept once asked for.
class Font {
 public:
  /// Looks in TRIBOLOG_FONT_DIR if that is set, otherwise where Debian and Ubuntu install it.
  /// @throw tribolog::FigureError if the font is not there; names the package fonts-dejavu-core.
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  [[nodiscard]] const std::string& file(Weight weight) const;
  [[nodiscard]] bool has(Weight weight, char32_t c) const;
  /// The number of its glyph in the file; 0 if it has none.
  [[nodiscard]] unsigned glyph(Weight weight, char32_t c) const;
  [[nodiscard]] const GlyphMeasure& measure(Weight weight, int size_px, char32_t c) const;
  /// What to add between two glyphs.
  [[nodiscard]] double kerning(Weight weight, int size_px, char32_t left, char32_t right) const;

  static std::string freetype_version();

 private:
  struct Faces;
  std::unique_ptr<Faces> faces_;
};

}  // namespace tribolog::render::text
