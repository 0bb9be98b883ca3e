#include "render/text/font.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <unordered_map>
#include <vector>

#include <ft2build.h>
#include FT_FREETYPE_H

#include "base/error.h"

namespace tribolog::render::text {
namespace {

constexpr std::array<const char*, 2> file_names{"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"};

std::vector<std::string> font_directories() {
  if (const char* own = std::getenv("TRIBOLOG_FONT_DIR"); own != nullptr && *own != '\0') {
    return {own};
  }
  return {"/usr/share/fonts/truetype/dejavu", "/usr/share/fonts/dejavu-sans-fonts",
          "/usr/share/fonts/TTF", "/usr/share/fonts/dejavu"};
}

std::string directory_with_font() {
  std::string searched;
  for (const std::string& directory : font_directories()) {
    std::error_code ignored;
    bool complete = true;
    for (const char* name : file_names) {
      complete = complete && std::filesystem::is_regular_file(directory + "/" + name, ignored);
    }
    if (complete) return directory;
    searched += (searched.empty() ? "" : ", ") + directory;
  }
  throw FigureError({"drawing.no_font", {{"folders", searched}}});
}

double pixels(FT_Pos value_26_6) { return static_cast<double>(value_26_6) / 64.0; }

}  // namespace

struct Font::Faces {
  struct One {
    std::string file;
    FT_Face face{};
    int size_px{};
  };

  FT_Library library{};
  std::array<One, 2> faces{};
  std::unordered_map<std::uint64_t, GlyphMeasure> measures;

  ~Faces() {
    if (library != nullptr) FT_Done_FreeType(library);  // and its faces
  }

  One& at(Weight weight) { return faces[weight == Weight::bold ? 1 : 0]; }

  FT_Face sized(Weight weight, int size_px) {
    One& one = at(weight);
    if (one.size_px != size_px) {
      FT_Set_Pixel_Sizes(one.face, 0, static_cast<FT_UInt>(size_px));
      one.size_px = size_px;
    }
    return one.face;
  }
};

Font::Font() : faces_(std::make_unique<Faces>()) {
  const std::string directory = directory_with_font();
  if (FT_Init_FreeType(&faces_->library) != 0) throw FigureError({"drawing.no_freetype"});
  for (const Weight weight : {Weight::regular, Weight::bold}) {
    Faces::One& one = faces_->at(weight);
    one.file = directory + "/" + file_names[weight == Weight::bold ? 1 : 0];
    if (FT_New_Face(faces_->library, one.file.c_str(), 0, &one.face) != 0) {
      throw FigureError({"drawing.font_not_readable", {{"file", one.file}}});
    }
  }
}

Font::~Font() = default;

const std::string& Font::file(Weight weight) const { return faces_->at(weight).file; }

bool Font::has(Weight weight, char32_t c) const { return glyph(weight, c) != 0; }

unsigned Font::glyph(Weight weight, char32_t c) const {
  return FT_Get_Char_Index(faces_->at(weight).face, c);
}

const GlyphMeasure& Font::measure(Weight weight, int size_px, char32_t c) const {
  const std::uint64_t key = (static_cast<std::uint64_t>(size_px) << 32U) |
                            (weight == Weight::bold ? 1ULL << 31U : 0U) | c;
  const auto known = faces_->measures.find(key);
  if (known != faces_->measures.end()) return known->second;
  GlyphMeasure out;
  FT_Face face = faces_->sized(weight, size_px);
  if (FT_Load_Char(face, c, FT_LOAD_DEFAULT) == 0) {
    const FT_Glyph_Metrics& metrics = face->glyph->metrics;
    out.advance = pixels(face->glyph->advance.x);
    out.left = pixels(metrics.horiBearingX);
    out.right = out.left + pixels(metrics.width);
    out.top = pixels(metrics.horiBearingY);
    out.bottom = out.top - pixels(metrics.height);
  }
  return faces_->measures.emplace(key, out).first->second;
}

double Font::kerning(Weight weight, int size_px, char32_t left, char32_t right) const {
  FT_Face face = faces_->sized(weight, size_px);
  if (!FT_HAS_KERNING(face)) return 0.0;
  FT_Vector delta{};
  FT_Get_Kerning(face, FT_Get_Char_Index(face, left), FT_Get_Char_Index(face, right),
                 FT_KERNING_DEFAULT, &delta);
  return pixels(delta.x);
}

std::string Font::freetype_version() {
  FT_Library library{};
  if (FT_Init_FreeType(&library) != 0) return "unknown";
  FT_Int major{};
  FT_Int minor{};
  FT_Int patch{};
  FT_Library_Version(library, &major, &minor, &patch);
  FT_Done_FreeType(library);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace tribolog::render::text
