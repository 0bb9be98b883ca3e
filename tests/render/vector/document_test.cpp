// What stands in the documents besides the picture.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/composition/figure_layout.h"
#include "render/example_diagram.h"
#include "render/example_figures.h"
#include "render/text/font.h"
#include "render/vector/outside_renderers.h"
#include "render/vector/vector_canvas.h"
#include "render/vector/vector_document.h"

namespace tribolog::render::document_test {
namespace {

const vector::DocumentTexts words{"fig-1", "A loop", "Torque over angle, 1.8 N·m high"};

TEST(VectorDocument, IsTheSameEachTime) {
  const text::Font font;
  for (const figure::Figure& figure : {examples::stacked(), examples::diagram()}) {
    const figure::DrawList list = composition::lay_out(figure, font);
    EXPECT_EQ(vector::svg_document(list, words, font),
              vector::svg_document(list, words, text::Font()));
    EXPECT_EQ(vector::pdf_document(list, words, font),
              vector::pdf_document(list, words, text::Font()));
  }
}

TEST(VectorDocument, KeepsTextAsText) {
  const text::Font font;
  const figure::DrawList list = composition::lay_out(examples::hysteresis(), font);
  const std::vector<std::string> texts = texts_of_svg(vector::svg_document(list, words, font));
  for (const char* text : {"joint angle q [°]", "driving torque T [N·m]", "measured", "mid-line",
                           "hysteresis", "A", "−2.0"}) {
    EXPECT_NE(std::find(texts.begin(), texts.end(), text), texts.end()) << text;
  }
  if (!has_program("pdftotext")) GTEST_SKIP() << "poppler-utils is not installed";
  std::string found = text_by_poppler(vector::pdf_document(list, words, font));
  std::replace(found.begin(), found.end(), '\n', ' ');  // it breaks what reads upwards
  for (const char* text :
       {"joint angle q [°]", "driving torque T [N·m]", "measured", "mid-line", "hysteresis"}) {
    EXPECT_NE(found.find(text), std::string::npos) << text << " in " << found;
  }
}

TEST(VectorDocument, CarriesASmallPartOfEachFont) {
  if (!has_program("pdffonts")) GTEST_SKIP() << "poppler-utils is not installed";
  const text::Font font;
  const figure::DrawList list = composition::lay_out(examples::hysteresis(), font);
  const std::vector<std::string> fonts = fonts_by_poppler(vector::pdf_document(list, words, font));
  ASSERT_EQ(fonts.size(), 2U);
  for (const std::string& line : fonts) {
    EXPECT_EQ(line.find("+DejaVuSans"), 6U) << line;
    EXPECT_NE(line.find("CID TrueType      Identity-H       yes yes yes"), std::string::npos)
        << line << ": embedded, a subset, with a map to Unicode";
  }
}

// A line with a subscript is one text, which can be searched for.
TEST(VectorDocument, KeepsALineTogether) {
  const text::Font font;
  figure::Figure figure = examples::plain();
  figure.panels[0].x.title = "friction T_{f} at rest [N·m^{2}]";
  figure.panels[0].y.title = "speed φ\u0307_{max} of it";
  const figure::DrawList list = composition::lay_out(figure, font);
  const std::vector<std::string> texts = texts_of_svg(vector::svg_document(list, words, font));
  for (const char* text : {"friction Tf at rest [N·m2]"}) {
    EXPECT_NE(std::find(texts.begin(), texts.end(), text), texts.end()) << text;
  }
}

TEST(VectorDocument, StatesTitleAndPictureInWords) {
  const text::Font font;
  const figure::DrawList list = composition::lay_out(examples::plain(), font);
  const std::vector<std::string> texts = texts_of_svg(vector::svg_document(list, words, font));
  ASSERT_GE(texts.size(), 2U);
  EXPECT_EQ(texts[0], words.title);
  EXPECT_EQ(texts[1], words.description);
  const std::string pdf = vector::pdf_document(list, words, font);
  // UTF-16: "A loop", and the dot of "N·m".
  EXPECT_NE(pdf.find("/Title <FEFF00410020006C006F006F0070>"), std::string::npos);
  EXPECT_NE(pdf.find("/Alt <FEFF"), std::string::npos);
  EXPECT_NE(pdf.find("004E00B7006D"), std::string::npos);
}

TEST(VectorDocument, IsAsLargeAsInPrint) {
  const text::Font font;
  figure::Figure figure = examples::plain();
  figure.width_px = 1680;
  figure.height_px = 1200;
  figure.width_mm = 84;
  const figure::DrawList list = composition::lay_out(figure, font);
  EXPECT_NE(vector::svg_document(list, words, font)
                .find("width=\"84mm\" height=\"60mm\" viewBox=\"0 0 1680 1200\""),
            std::string::npos);
  // 84 mm are 238.11 points, 60 mm are 170.079.
  EXPECT_NE(vector::pdf_document(list, words, font).find("/MediaBox [0 0 238.11 170.079]"),
            std::string::npos);
}

TEST(VectorDocument, OfASceneNeedsThePictureOfItsSolidParts) {
  const text::Font font;
  const figure::DrawList list = composition::lay_out(examples::scene(), font);
  EXPECT_THROW(vector::svg_document(list, words, font), FigureError);
  EXPECT_THROW(vector::pdf_document(list, words, font), FigureError);
  const std::vector<std::byte> no_picture(100);
  EXPECT_THROW(vector::pdf_document(list, words, font, no_picture), FigureError);
}

TEST(VectorDocument, HasTransparentColours) {
  const text::Font font;
  figure::Figure figure = examples::plain();
  figure.panels[0].bands.push_back({"band", {0, 3}, {0.2, 0.2}, {0.4, 0.4}, {0, 114, 178, 51}});
  const figure::DrawList list = composition::lay_out(figure, font);
  EXPECT_NE(vector::svg_document(list, words, font).find("fill=\"#0072b2\" fill-opacity=\"0.2\""),
            std::string::npos);
  EXPECT_NE(vector::pdf_document(list, words, font).find("/A51 << /ca 0.2 /CA 0.2 >>"),
            std::string::npos);
}

TEST(VectorDocument, NeedsNoText) {
  const text::Font font;
  figure::DrawList list;
  list.width = 100;
  list.height = 50;
  list.primitives.emplace_back(
      figure::Polyline{{}, {{0, 0}, {100, 50}}, 2, figure::palette::blue, {}});
  EXPECT_EQ(texts_of_svg(vector::svg_document(list, {}, font)), std::vector<std::string>{""});
  const std::string pdf = vector::pdf_document(list, {}, font);
  if (!has_program("qpdf")) GTEST_SKIP() << "qpdf is not installed";
  EXPECT_EQ(complaints_of_qpdf(pdf), "");
}

TEST(ShortNumber, HasNoMoreDigitsThanItTakes) {
  EXPECT_EQ(vector::short_number(12.5), "12.5");
  EXPECT_EQ(vector::short_number(3.0), "3");
  EXPECT_EQ(vector::short_number(100), "100");
  EXPECT_EQ(vector::short_number(-0.004), "0");
  EXPECT_EQ(vector::short_number(-0.07), "-0.07");
  EXPECT_EQ(vector::short_number(1234.567), "1234.57");
  EXPECT_EQ(vector::short_number(0.28346457, 6), "0.283465");
  EXPECT_EQ(vector::short_number(1500, 0), "1500");
  EXPECT_EQ(vector::short_number(std::nan("")), "0");
}

}  // namespace
}  // namespace tribolog::render::document_test
