// Texts that would like to be markup, operators or commands are shown as text.

#include <algorithm>

#include <gtest/gtest.h>

#include "render/composition/figure_layout.h"
#include "render/example_figures.h"
#include "render/text/font.h"
#include "render/vector/outside_renderers.h"
#include "render/vector/vector_document.h"

namespace tribolog::render::hostile_text_test {
namespace {

using namespace std::string_literals;

/// What is given, and what is shown: control characters, and those that turn the direction of
/// reading, appear as question marks.
struct Hostile {
  std::string given;
  std::string shown;
};

std::vector<Hostile> hostile_texts() {
  return {{"<script>alert(1)</script>", "<script>alert(1)</script>"},
          {"]]><x/>", "]]><x/>"},
          {"&lt; &amp; &#0; &nbsp;", "&lt; &amp; &#0; &nbsp;"},
          {"\" onload='x' \"", "\" onload='x' \""},
          {R"(a) Tj (b \) \( \\)", R"(a) Tj (b \) \( \\)"},
          {"<FEFF> endstream endobj %%EOF", "<FEFF> endstream endobj %%EOF"},
          {"left\u202eright\u2066x\u200f", "left?right?x?"},
          {"nul\0end"s, "nul?end"},
          {"bell\a and \x1b[31m", "bell? and ?[31m"},
          {"cut \xe2\x82 off \xff", "cut ? off ?"},
          {"{0} {{}} %s %n", "{0} {{}} %s %n"},
          {"url(javascript:x)", "url(javascript:x)"},
          {"ﬁne Ω≤∫ żółć", "ﬁne Ω≤∫ żółć"}};
}

figure::Figure figure_with(const std::string& text) {
  figure::Figure figure = examples::plain();
  figure.title = text;
  figure.panels[0].x.title = text;
  figure.panels[0].series[0].label = text;
  return figure;
}

TEST(HostileTexts, AreTextInSvg) {
  const text::Font font;
  for (const auto& [given, shown] : hostile_texts()) {
    const figure::DrawList list = composition::lay_out(figure_with(given), font);
    const std::string svg = vector::svg_document(list, {"id\" onload=\"x", given, given}, font);
    const std::vector<std::string> texts = texts_of_svg(svg);  // throws if not well-formed
    ASSERT_GT(texts.size(), 4U);
    EXPECT_EQ(texts[0], shown);
    EXPECT_EQ(texts[1], shown);
    EXPECT_GE(std::count(texts.begin() + 2, texts.end(), shown), 3) << shown;
    EXPECT_EQ(svg.find("onload=\"x\""), std::string::npos);
    EXPECT_EQ(svg.find("<script"), std::string::npos);
  }
}

TEST(HostileTexts, AreTextInPdf) {
  if (!has_program("pdftotext") || !has_program("qpdf")) {
    GTEST_SKIP() << "poppler-utils or qpdf is not installed";
  }
  const text::Font font;
  for (const auto& [given, shown] : hostile_texts()) {
    const figure::DrawList list = composition::lay_out(figure_with(given), font);
    const std::string pdf = vector::pdf_document(list, {"id", given, given}, font);
    EXPECT_EQ(complaints_of_qpdf(pdf), "") << shown;
    const std::string found = text_by_poppler(pdf);
    std::size_t times = 0;
    for (std::size_t at = found.find(shown); at != std::string::npos;
         at = found.find(shown, at + 1)) {
      ++times;
    }
    EXPECT_GE(times, 3U) << shown << " in " << found;
  }
}

TEST(HostileTexts, AreOrdinaryInEveryField) {
  const text::Font font;
  for (const figure::Figure& figure : examples::nasty()) {
    const figure::DrawList list = composition::lay_out(figure, font);
    const vector::DocumentTexts texts{figure.id, figure.title, figure.title};
    EXPECT_NO_THROW(texts_of_svg(vector::svg_document(list, texts, font))) << figure.id;
    const std::string pdf = vector::pdf_document(list, texts, font);
    if (has_program("qpdf")) {
      EXPECT_EQ(complaints_of_qpdf(pdf), "") << figure.id;
    }
  }
}

}  // namespace
}  // namespace tribolog::render::hostile_text_test
