#include <cstdlib>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/text/characters.h"
#include "render/text/text_line.h"
#include "wording/words.h"

namespace tribolog::render::text_test {
namespace {

TEST(Utf8, ReplacesWhatIsNotText) {
  EXPECT_EQ(text::decode_utf8("a\xFF"
                              "b")
                .text,
            U"a?b");
  EXPECT_EQ(text::decode_utf8("\xC0\xAF").replaced, 1U) << "overlong";
  EXPECT_EQ(text::decode_utf8("\xED\xA0\x80").replaced, 1U) << "surrogate";
  EXPECT_EQ(text::decode_utf8("\xF4\x90\x80\x80").replaced, 1U) << "beyond Unicode";
  EXPECT_EQ(text::decode_utf8("\xE2\x82").replaced, 1U) << "cut off";
  EXPECT_EQ(text::decode_utf8("a\tb\x1b").text, U"a b?");
  EXPECT_EQ(text::encode_utf8(text::decode_utf8("φ̇ 10⁻⁶ 😀").text), "φ̇ 10⁻⁶ 😀");
}

TEST(Markup, SplitsScripts) {
  const auto runs = text::parse_markup("T_{f} [N·m^{2}]").runs;
  ASSERT_EQ(runs.size(), 5U);
  EXPECT_EQ(runs[1].shift, text::Shift::subscript);
  EXPECT_EQ(runs[1].text, U"f");
  EXPECT_EQ(runs[3].shift, text::Shift::superscript);
}

TEST(Markup, PrintsLoneSignsAsTheyAre) {
  for (const char* text : {"a_b^c", "x_{never closed", "}{", "_", "^{"}) {
    const auto runs = text::parse_markup(text).runs;
    ASSERT_EQ(runs.size(), 1U) << text;
    EXPECT_EQ(text::encode_utf8(runs[0].text), text);
  }
}

TEST(TextLine, LowersSubscriptsAndRaisesSuperscripts) {
  const text::Font font;
  text::TextFaults faults;
  const text::TextLine line = text::shape_line(font, "x_{1}y^{2}", {40}, faults);
  ASSERT_EQ(line.pieces.size(), 4U);
  EXPECT_LT(line.pieces[1].raise, 0);
  EXPECT_GT(line.pieces[3].raise, 0);
  EXPECT_EQ(line.pieces[1].size_px, 28);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_NEAR(line.pieces[i].offset, line.pieces[i - 1].offset + line.pieces[i - 1].advance,
                1e-9);
  }
}

TEST(TextLine, PutsADotOverTheMiddleOfItsLetter) {
  const text::Font font;
  text::TextFaults faults;
  for (const char* text : {"q\u0307", "φ\u0307", "τ\u0307"}) {
    const text::TextLine line = text::shape_line(font, text, {40}, faults);
    ASSERT_EQ(line.pieces.size(), 2U) << text;
    const char32_t letter = text::decode_utf8(text).text[0];
    const text::GlyphMeasure below = font.measure(text::Weight::regular, 40, letter);
    const text::GlyphMeasure dot = font.measure(text::Weight::regular, 40, U'\u02D9');
    const double centre = line.pieces[1].offset + (dot.left + dot.right) / 2;
    EXPECT_NEAR(centre, (below.left + below.right) / 2, 0.6) << text;
    EXPECT_GT(line.pieces[1].raise + dot.bottom, below.top - 1) << text;
    EXPECT_NEAR(line.width, below.advance, 1e-9) << "a mark takes no room";
  }
  const text::TextLine z = text::shape_line(font, "z\u0307", {40}, faults);
  ASSERT_EQ(z.pieces.size(), 1U);
  EXPECT_EQ(z.pieces[0].text, "ż");
}

TEST(TextLine, SubstitutesMissingGlyphs) {
  const text::Font font;
  text::TextFaults faults;
  const text::TextLine line = text::shape_line(font, "a中b", {26}, faults);
  EXPECT_EQ(line.pieces.at(0).text, "a?b");
  EXPECT_EQ(faults.without_glyph, U"中");
}

TEST(TextLine, WrapsBetweenWordsAndCutsTheRest) {
  const text::Font font;
  text::TextFaults faults;
  bool cut = false;
  const text::TextStyle style{26};
  const auto two =
      text::wrap_lines(font, "friction torque of the joint", style, 220, 3, faults, cut);
  EXPECT_GT(two.size(), 1U);
  EXPECT_FALSE(cut);
  const auto one = text::wrap_lines(font, std::string(500, 'm'), style, 220, 1, faults, cut);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_TRUE(cut);
  EXPECT_LE(one[0].width, 220);
}

TEST(Font, HasWhatFiguresNeed) {
  const text::Font font;
  for (const char32_t c : U"φθσατμω·°−×±…₀₁₂²³⁻˙¨ˆ") {
    if (c != 0) {
      EXPECT_TRUE(font.has(text::Weight::regular, c)) << static_cast<unsigned>(c);
    }
  }
}

TEST(Font, NamesThePackageWhenItIsMissing) {
  setenv("TRIBOLOG_FONT_DIR", "/nonexistent", 1);
  try {
    const text::Font font;
    ADD_FAILURE() << "no error";
  } catch (const FigureError& error) {
    EXPECT_NE(wording::words(error).find("fonts-dejavu-core"), std::string::npos);
  }
  unsetenv("TRIBOLOG_FONT_DIR");
}

}  // namespace
}  // namespace tribolog::render::text_test
