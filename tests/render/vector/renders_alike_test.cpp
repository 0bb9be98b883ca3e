// Documents, drawn by programs of others, hold what our painter paints.

#include <algorithm>

#include <gtest/gtest.h>

#include "render/check/picture_check.h"
#include "render/text/font.h"
#include "render/vector/drawn_set.h"
#include "render/vector/outside_renderers.h"
#include "render/vector/picture_match.h"
#include "support/breadth.h"
#include "wording/words.h"

namespace tribolog::render::renders_alike_test {
namespace {

constexpr double least_ink = 0.995;  // of the points at which our picture shows a primitive

void expect_alike(const DrawnExample& example, const figure::Picture& other,
                  const std::string& by) {
  const std::string name = example.figure.figure.id + " by " + by;
  EXPECT_LE(unmatched_share(example.picture, other), most_unmatched(example.list)) << name;
  const SampledInk ink = sampled_ink(example.list, example.picture, other);
  EXPECT_GE(static_cast<double>(ink.found), least_ink * static_cast<double>(ink.asked))
      << name << ": " << ink.found << " of " << ink.asked;
  const Statement error = check::check_picture(example.list, example.figure.figure, other).error;
  EXPECT_TRUE(error.empty()) << name << ": " << wording::words(error);
}

void expect_pdf_alike(const std::vector<figures::ReportFigure>& figures) {
  if (!has_program("pdftocairo") || !has_program("qpdf")) {
    GTEST_SKIP() << "poppler-utils or qpdf is not installed";
  }
  const text::Font font;
  for (const DrawnExample& one : drawn(test::some_of(figures, 4))) {
    const std::string pdf = vector::pdf_document(one.list, one.texts(), font, one.solid_parts);
    const int width = one.list.width;
    const int height = one.list.height;
    expect_alike(one, pdf_by_cairo(pdf, width, height), "cairo");
    // It widens lines to whole pixels: held against what must be seen, not pixel by pixel.
    const Statement error =
        check::check_picture(one.list, one.figure.figure, pdf_by_splash(pdf, width, height)).error;
    EXPECT_TRUE(error.empty()) << one.figure.figure.id << ": " << wording::words(error);
    EXPECT_EQ(complaints_of_qpdf(pdf), "") << one.figure.figure.id;
  }
}

void expect_svg_alike(const std::vector<figures::ReportFigure>& figures) {
  if (!has_program("rsvg-convert")) GTEST_SKIP() << "librsvg2-bin is not installed";
  const text::Font font;
  for (const DrawnExample& one : drawn(test::some_of(figures, 4))) {
    const std::string svg = vector::svg_document(one.list, one.texts(), font, one.solid_parts);
    expect_alike(one, svg_by_librsvg(svg, one.list.width, one.list.height), "librsvg");
    EXPECT_GT(texts_of_svg(svg).size(), 2U) << one.figure.figure.id;
  }
}

TEST(RendersAlike, PaperAsPdf) {
  TRIBOLOG_EACH_NIGHT();
  expect_pdf_alike(paper_set());
}
TEST(RendersAlike, PaperAsSvg) {
  TRIBOLOG_EACH_NIGHT();
  expect_svg_alike(paper_set());
}
TEST(RendersAlike, HistoryAsPdf) {
  TRIBOLOG_EACH_NIGHT();
  expect_pdf_alike(history_set());
}
TEST(RendersAlike, HistoryAsSvg) { expect_svg_alike(history_set()); }
TEST(RendersAlike, PublicationAsPdf) { expect_pdf_alike(publication_set()); }
TEST(RendersAlike, PublicationAsSvg) {
  TRIBOLOG_EACH_NIGHT();
  expect_svg_alike(publication_set());
}
TEST(RendersAlike, TroubleAsPdf) { expect_pdf_alike(trouble_set()); }
TEST(RendersAlike, TroubleAsSvg) { expect_svg_alike(trouble_set()); }

TEST(RendersAlike, InABrowserWithTheDocumentsOwnFont) {
  if (!has_program("chromium")) GTEST_SKIP() << "chromium is not installed";
  const text::Font font;
  std::vector<figures::ReportFigure> some;
  for (figures::ReportFigure& one : paper_set()) {
    if (one.paper_number == 3 || one.paper_number == 10 || one.paper_number == 15)
      some.push_back(std::move(one));
  }
  for (const DrawnExample& one : drawn(some)) {
    std::string svg = vector::svg_document(one.list, one.texts(), font, one.solid_parts);
    // No other font may help out.
    const std::string others = ", 'DejaVu Sans', sans-serif";
    ASSERT_NE(svg.find(others), std::string::npos);
    svg.replace(svg.find(others), others.size(), "");
    expect_alike(one, svg_by_chromium(svg, one.list.width, one.list.height), "chromium");
  }
}

// The measure itself: what is missing, moved or of another colour is seen.
TEST(RendersAlike, WouldFailForWhatIsNotAlike) {
  if (!has_program("rsvg-convert")) GTEST_SKIP() << "librsvg2-bin is not installed";
  const text::Font font;
  std::vector<figures::ReportFigure> figures = history_set();
  figures.resize(1);
  const DrawnExample one = drawn(figures).at(0);
  const auto share_with = [&](const auto& change) {
    figure::DrawList list = one.list;
    change(list);
    return unmatched_share(
        one.picture,
        svg_by_librsvg(vector::svg_document(list, one.texts(), font), list.width, list.height));
  };
  const double most = most_unmatched(one.list);
  EXPECT_LE(share_with([](figure::DrawList&) {}), most);
  const auto first_of = [](figure::DrawList& list, figure::Role role) {
    return std::find_if(
        list.primitives.begin(), list.primitives.end(),
        [&](const figure::Primitive& p) { return figure::owner_of(p).role == role; });
  };
  EXPECT_GT(share_with([&](figure::DrawList& list) {
              list.primitives.erase(first_of(list, figure::Role::axis_title));
            }),
            most);
  EXPECT_GT(share_with([&](figure::DrawList& list) {
              std::get<figure::Polyline>(*first_of(list, figure::Role::axis)).colour =
                  figure::palette::vermilion;
            }),
            most);
  EXPECT_GT(share_with([&](figure::DrawList& list) {
              for (figure::Primitive& p : list.primitives) {
                if (auto* run = std::get_if<figure::TextRun>(&p)) run->baseline.y += 6;
              }
            }),
            most);
}

}  // namespace
}  // namespace tribolog::render::renders_alike_test
