// Each check of legibility finds what it is for: a figure with one fault, and the same without.

#include <gtest/gtest.h>

#include "render/composition/figure_layout.h"
#include "render/example_figures.h"
#include "render/figure/drawing_style.h"
#include "render/legibility/contrast.h"
#include "render/legibility/letter_sizes.h"
#include "render/legibility/panel_content.h"
#include "render/legibility/picture_border.h"
#include "render/legibility/text_collisions.h"
#include "render/legibility/texts_of_list.h"

namespace tribolog::render::legibility::legibility_test {
namespace {

constexpr figure::Colour dark{25, 25, 25};
constexpr figure::Colour paper{255, 255, 255};

figure::TextRun run(const std::string& text, const figure::PixelBox& box, int index = 0) {
  figure::TextRun out;
  out.owner = {figure::Role::label_text, 0, index};
  out.text = text;
  out.size = 26;
  out.colour = dark;
  out.box = box;
  return out;
}

figure::Polygon ground(const figure::PixelBox& box, figure::Role role, figure::Colour colour) {
  return {
      {role, 0, 0},
      {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}},
      colour};
}

figure::Polyline curve(figure::PixelPoint from, figure::PixelPoint to,
                       figure::Colour colour = figure::palette::blue) {
  return {{figure::Role::series, 0, 0}, {from, to}, 4, colour, {}};
}

figure::Markers dots(std::vector<figure::PixelPoint> centres) {
  return {{figure::Role::series_marker, 0, 0},
          figure::Marker::circle,
          std::move(centres),
          12,
          figure::palette::blue};
}

figure::DrawList list_of(std::vector<figure::Primitive> primitives) {
  figure::DrawList list;
  list.width = 1600;
  list.height = 1000;
  list.plots = {{100, 100, 1500, 900}};
  list.primitives = std::move(primitives);
  return list;
}

const figure::PixelBox place{300, 300, 420, 330};

TEST(Legibility, FindsTextsOverEachOther) {
  const auto found =
      overlapping_texts(list_of({run("A", place), run("B", place.moved(100, 10), 1)}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(in_words(found[0]), "the text 'B' lies over 'A' at 400..520 x 310..340 px");
  EXPECT_TRUE(
      overlapping_texts(list_of({run("A", place), run("B", place.moved(121, 0), 1)})).empty());
  // An index belongs to its letter.
  EXPECT_TRUE(overlapping_texts(list_of({run("A", place), run("1", place.moved(118, 8))})).empty());
}

TEST(Legibility, FindsTextsOffThePicture) {
  EXPECT_EQ(texts_off_the_picture(list_of({run("A", {1550, 10, 1601, 30})})).size(), 1U);
  EXPECT_EQ(texts_off_the_picture(list_of({run("A", {-1, 10, 40, 30})})).size(), 1U);
  EXPECT_TRUE(texts_off_the_picture(list_of({run("A", {1550, 10, 1600, 30})})).empty());
}

TEST(Legibility, FindsTextsOnDataUnlessTheyHaveABacking) {
  const figure::Polyline through = curve({200, 315}, {600, 315});
  const figure::Polygon backing =
      ground(place.grown(3), figure::Role::text_backing, {255, 255, 255, 215});
  EXPECT_EQ(texts_on_data(list_of({through, run("A", place)})).size(), 1U);
  EXPECT_TRUE(texts_on_data(list_of({through, backing, run("A", place)})).empty());
  EXPECT_EQ(texts_on_data(list_of({backing, through, run("A", place)})).size(), 1U)
      << "a backing below the curve hides nothing of it";
  EXPECT_EQ(texts_on_data(list_of({backing, run("A", place), through})).size(), 1U)
      << "the curve is painted over the text";
  EXPECT_TRUE(texts_on_data(list_of({curve({200, 340}, {600, 340}), run("A", place)})).empty());
  EXPECT_EQ(texts_on_data(list_of({dots({{310, 333}}), run("A", place)})).size(), 1U);
}

TEST(Legibility, FindsSingleMarkersUnderATextButNotACloud) {
  const figure::Polygon backing =
      ground(place.grown(3), figure::Role::text_backing, {255, 255, 255, 215});
  EXPECT_EQ(markers_under_texts(list_of({dots({{350, 332}}), backing, run("A", place)})).size(),
            1U);
  EXPECT_TRUE(markers_under_texts(list_of({dots({{350, 340}}), backing, run("A", place)})).empty());
  const std::vector<figure::PixelPoint> many(200, {350, 315});
  EXPECT_TRUE(markers_under_texts(list_of({dots(many), backing, run("A", place)})).empty());
  figure::Polyline bar = curve({350, 100}, {350, 800});
  bar.owner.role = figure::Role::error_bar;
  EXPECT_EQ(markers_under_texts(list_of({bar, backing, run("A", place)})).size(), 1U);
}

TEST(Legibility, FindsCurvesThatALabelHides) {
  const figure::Polygon backing =
      ground(place.grown(3), figure::Role::text_backing, {255, 255, 255, 215});
  const auto found =
      curves_under_labels(list_of({curve({200, 315}, {600, 315}), backing, run("A", place)}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "the text 'A' hides a curve (1 of panel 1)");
  EXPECT_TRUE(
      curves_under_labels(list_of({curve({200, 340}, {600, 340}), backing, run("A", place)}))
          .empty());
  figure::Polyline level = curve({200, 315}, {600, 315});
  level.owner.role = figure::Role::reference_line;
  EXPECT_TRUE(curves_under_labels(list_of({level, backing, run("A", place)})).empty());
}

TEST(Legibility, FindsDataUnderALegend) {
  const figure::Polygon legend = ground({200, 200, 400, 400}, figure::Role::legend_box, paper);
  EXPECT_EQ(data_under_legends(list_of({curve({100, 300}, {500, 300}), legend})).size(), 1U);
  EXPECT_TRUE(data_under_legends(list_of({curve({100, 500}, {500, 500}), legend})).empty());
}

TEST(Contrast, IsThatOfTheGuidelines) {
  EXPECT_NEAR(figure::contrast_ratio({0, 0, 0}, paper), 21, 1e-9);
  EXPECT_NEAR(figure::contrast_ratio(paper, paper), 1, 1e-9);
  // The two greys that every table of the guidelines has: just enough, and just not.
  EXPECT_GE(figure::contrast_ratio({118, 118, 118}, paper), 4.5);
  EXPECT_LT(figure::contrast_ratio({119, 119, 119}, paper), 4.5);
  EXPECT_EQ(laid_on(paper, {0, 0, 0, 128}), (figure::Colour{127, 127, 127}));
}

TEST(Contrast, DarkensColoursUntilLettersInThemAreReadable) {
  for (const figure::Colour colour :
       {figure::palette::orange, figure::palette::sky_blue, figure::palette::green,
        figure::palette::yellow, figure::palette::vermilion, figure::palette::purple,
        figure::palette::grey}) {
    const figure::Colour darker = figure::readable_on_paper(colour);
    EXPECT_GE(figure::contrast_ratio(darker, paper), figure::least_text_contrast);
    EXPECT_LT(figure::contrast_ratio(darker, paper), 5.2) << "no darker than needed";
  }
  EXPECT_EQ(figure::readable_on_paper(figure::palette::blue), figure::palette::blue);
}

TEST(Legibility, FindsFaintTexts) {
  figure::TextRun orange = run("A", place);
  orange.colour = figure::palette::orange;
  EXPECT_EQ(faint_texts(list_of({orange})).size(), 1U);
  EXPECT_TRUE(faint_texts(list_of({run("A", place)})).empty());
  const figure::Polygon shade = ground(place.grown(3), figure::Role::block_fill, {60, 60, 60});
  EXPECT_EQ(faint_texts(list_of({shade, run("A", place)})).size(), 1U);
  const figure::Polygon backing =
      ground(place.grown(3), figure::Role::text_backing, {255, 255, 255, 215});
  EXPECT_TRUE(faint_texts(list_of({shade, backing, run("A", place)})).empty());
}

TEST(Legibility, FindsFaintLines) {
  constexpr figure::Colour pale{200, 200, 200};
  EXPECT_EQ(faint_lines(list_of({curve({200, 200}, {400, 400}, pale)})).size(), 1U);
  EXPECT_TRUE(
      faint_lines(list_of({curve({200, 200}, {400, 400}, figure::palette::purple)})).empty());
  EXPECT_TRUE(
      faint_lines(list_of({curve({200, 200}, {400, 400}, pale), curve({0, 0}, {9, 9})})).empty())
      << "samples under their fit";
  figure::Polyline thin = curve({200, 200}, {400, 400}, figure::palette::orange);
  thin.width = 1;
  EXPECT_EQ(faint_lines(list_of({thin})).size(), 1U);
}

TEST(Legibility, FindsSmallLetters) {
  figure::TextRun small = run("A", place);
  small.size = 20;  // at 10 px to the millimetre
  EXPECT_EQ(small_letters(list_of({small}), 7).size(), 1U);
  EXPECT_TRUE(small_letters(list_of({run("A", place)}), 7).empty());
  small.box = place.moved(118, 8);
  EXPECT_TRUE(small_letters(list_of({run("A", place), small}), 7).empty()) << "an index";
}

TEST(Legibility, FindsPanelsWithoutData) {
  figure::Figure figure = examples::plain();
  const text::Font font;
  EXPECT_TRUE(empty_panels(composition::lay_out(figure, font), figure).empty());
  figure.panels.push_back(figure.panels.front());
  figure.panels.back().series.clear();
  const auto found = empty_panels(composition::lay_out(figure, font), figure);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "panel 2 shows no data");
}

TEST(Legibility, FindsAxesWithoutUnit) {
  figure::Figure figure;
  figure.panels.resize(1);
  figure.panels[0].x.title = "time t [s]";
  figure.panels[0].y.title = "torque T";
  EXPECT_EQ(axes_without_unit(figure, {}).size(), 1U);
  EXPECT_TRUE(axes_without_unit(figure, {"torque T"}).empty());
  figure.panels[0].y.title = "torque T []";
  EXPECT_EQ(axes_without_unit(figure, {}).size(), 1U);
  figure.panels[0].y.title = "";
  EXPECT_EQ(axes_without_unit(figure, {}).size(), 1U);
}

TEST(Legibility, FindsDataOutsideTheAxes) {
  EXPECT_EQ(data_outside_axes(list_of({curve({200, 200}, {1510, 400})})).size(), 1U);
  EXPECT_TRUE(data_outside_axes(list_of({curve({200, 200}, {1500, 400})})).empty());
}

TEST(Legibility, FindsInkAtTheBorderOfAPicture) {
  figure::Picture picture{4, 3, std::vector<std::uint8_t>(36, 255)};
  EXPECT_TRUE(ink_at_border(picture).empty());
  picture.rgb[0] = 254;
  EXPECT_TRUE(ink_at_border(picture).empty()) << "white of a palette";
  picture.rgb[3 * (4 + 1)] = 0;
  EXPECT_TRUE(ink_at_border(picture).empty()) << "inside";
  picture.rgb[3 * (8 + 2)] = 0;
  const auto found = ink_at_border(picture);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "ink at the lower edge");
}

TEST(Legibility, JoinsTheRunsOfAText) {
  const auto all = texts_of(
      list_of({run("T", place), run("f", place.moved(118, 8)), run("x", place.moved(0, 300), 1)}));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].words, "Tf");
}

}  // namespace
}  // namespace tribolog::render::legibility::legibility_test
