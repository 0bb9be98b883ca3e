// The font inside of a document, read by FreeType: the same letters as in the whole font.

#include <filesystem>
#include <fstream>
#include <memory>

#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "base/error.h"
#include "render/text/font.h"
#include "render/vector/true_type.h"
#include "support/run_program.h"

namespace tribolog::render::subset_test {
namespace {

// Letters, composed letters (one of parts that are moved, one of parts that are scaled), signs.
constexpr std::u32string_view sample = U"AVTo. ätżẏéÅ Ω₀½≤∫−φ?";

class Face {
 public:
  explicit Face(const std::string& bytes) : bytes_(bytes) {
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("no FreeType");
    if (FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes_.data()),
                           static_cast<FT_Long>(bytes_.size()), 0, &face_) != 0) {
      throw std::runtime_error("FreeType does not read the font");
    }
  }
  ~Face() { FT_Done_FreeType(library_); }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  /// Points of the outline, in font units, and the advance at the end.
  std::vector<long> outline(char32_t c) {
    std::vector<long> out;
    if (FT_Load_Char(face_, c, FT_LOAD_NO_SCALE) != 0) return out;
    const FT_Outline& outline = face_->glyph->outline;
    for (int i = 0; i < outline.n_points; ++i) {
      out.push_back(outline.points[i].x);
      out.push_back(outline.points[i].y);
      out.push_back(FT_CURVE_TAG(outline.tags[i]));
    }
    for (int i = 0; i < outline.n_contours; ++i) out.push_back(outline.contours[i]);
    out.push_back(face_->glyph->advance.x);
    return out;
  }
  long kerning(char32_t left, char32_t right) {
    FT_Vector delta{};
    FT_Get_Kerning(face_, FT_Get_Char_Index(face_, left), FT_Get_Char_Index(face_, right),
                   FT_KERNING_UNSCALED, &delta);
    return delta.x;
  }
  [[nodiscard]] bool has(char32_t c) const { return FT_Get_Char_Index(face_, c) != 0; }
  [[nodiscard]] long glyphs() const { return face_->num_glyphs; }

 private:
  std::string bytes_;
  FT_Library library_{};
  FT_Face face_{};
};

std::map<char32_t, unsigned> glyphs_of(const text::Font& font, text::Weight weight) {
  std::map<char32_t, unsigned> out;
  for (const char32_t c : sample) out.emplace(c, font.glyph(weight, c));
  return out;
}

TEST(TrueTypeSubset, HasTheSameLettersAsTheFont) {
  const text::Font font;
  for (const text::Weight weight : {text::Weight::regular, text::Weight::bold}) {
    const vector::TrueTypeFile file(font.file(weight));
    const vector::TrueTypeSubset subset =
        vector::true_type_subset(file, glyphs_of(font, weight), "T");
    Face whole(test::read_text(font.file(weight)));
    Face part(subset.bytes);
    for (const char32_t c : sample) {
      ASSERT_TRUE(whole.has(c)) << static_cast<unsigned>(c);
      EXPECT_EQ(part.outline(c), whole.outline(c)) << static_cast<unsigned>(c);
    }
    bool kerned = false;
    for (const char32_t left : sample) {
      for (const char32_t right : sample) {
        EXPECT_EQ(part.kerning(left, right), whole.kerning(left, right));
        kerned = kerned || part.kerning(left, right) != 0;
      }
    }
    EXPECT_TRUE(kerned) << "the sample has pairs that are kerned";
    EXPECT_FALSE(part.has(U'Q'));
    EXPECT_LT(part.glyphs(), 50);
    EXPECT_LT(subset.bytes.size(), 12'000U);
  }
}

TEST(TrueTypeSubset, IsTheSameEachTimeAndAddsUp) {
  const text::Font font;
  const vector::TrueTypeFile file(font.file(text::Weight::regular));
  const auto glyphs = glyphs_of(font, text::Weight::regular);
  const std::string bytes = vector::true_type_subset(file, glyphs, "T").bytes;
  EXPECT_EQ(vector::true_type_subset(file, glyphs, "T").bytes, bytes);
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 4) sum += vector::u32_at(bytes, i);
  EXPECT_EQ(sum, 0xB1B0AFBAU) << "of the whole file, as the format demands";
}

TEST(TrueTypeSubset, TakesCharactersOfEveryPlane) {
  const text::Font font;
  constexpr char32_t beyond = 0x1D538;  // a double-struck A
  if (!font.has(text::Weight::regular, beyond)) GTEST_SKIP() << "this version of the font has none";
  const vector::TrueTypeFile file(font.file(text::Weight::regular));
  const vector::TrueTypeSubset subset =
      vector::true_type_subset(file,
                               {{U'A', font.glyph(text::Weight::regular, U'A')},
                                {beyond, font.glyph(text::Weight::regular, beyond)}},
                               "T");
  Face whole(test::read_text(font.file(text::Weight::regular)));
  Face part(subset.bytes);
  EXPECT_EQ(part.outline(beyond), whole.outline(beyond));
}

TEST(TrueTypeFile, RefusesWhatIsNoUsableFont) {
  const text::Font font;
  const std::string whole = test::read_text(font.file(text::Weight::regular));
  const test::ScratchDirectory scratch;
  const auto read = [&](const std::string& bytes) {
    const vector::TrueTypeFile file(scratch.write("font.ttf", bytes));
    static_cast<void>(vector::true_type_subset(file, glyphs_of(font, text::Weight::regular), "T"));
  };
  EXPECT_THROW(vector::TrueTypeFile("/nonexistent.ttf"), FigureError);
  EXPECT_THROW(read(""), FigureError);
  EXPECT_THROW(read("OTTO" + whole.substr(4)), FigureError);
  EXPECT_THROW(read("not a font at all"), FigureError);
  for (std::size_t size = 1; size < whole.size(); size += 40'009) {
    EXPECT_THROW(read(whole.substr(0, size)), FigureError) << size;
  }
}

// No damage makes it read beyond its bytes (the sanitizers look on) or fail in another way.
TEST(TrueTypeFile, SurvivesDamage) {
  const text::Font font;
  const std::string whole = test::read_text(font.file(text::Weight::regular));
  const test::ScratchDirectory scratch;
  unsigned long long state = 1;
  int refused = 0;
  for (int round = 0; round < 60; ++round) {
    std::string damaged = whole;
    for (int k = 0; k < 400; ++k) {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      // The directory and the short tables as often as the outlines.
      const std::size_t reach = k % 2 == 0 ? 4096 : damaged.size();
      damaged[(state >> 20U) % reach] = static_cast<char>(state >> 56U);
    }
    try {
      const vector::TrueTypeFile file(scratch.write("font.ttf", damaged));
      static_cast<void>(
          vector::true_type_subset(file, glyphs_of(font, text::Weight::regular), "T"));
    } catch (const FigureError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(TrueTypeFile, RefusesAFontThatForbidsEmbedding) {
  const text::Font font;
  std::string bytes = test::read_text(font.file(text::Weight::regular));
  const std::size_t entry = bytes.find("OS/2");
  ASSERT_LT(entry, 400U);
  bytes[vector::u32_at(bytes, entry + 8) + 9] = 2;  // fsType: restricted licence
  const test::ScratchDirectory scratch;
  try {
    const vector::TrueTypeFile file(scratch.write("font.ttf", bytes));
    FAIL();
  } catch (const FigureError& error) {
    EXPECT_TRUE(error.statement().is("drawing.font_not_embeddable")) << error.what();
  }
}

}  // namespace
}  // namespace tribolog::render::subset_test
