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

namespace tribolog::render::legibility {
namespace {

constexpr Colour dark{25, 25, 25};
constexpr Colour paper{255, 255, 255};

TextRun run(const std::string& text, const PixelBox& box, int index = 0) {
  TextRun out;
  out.owner = {Role::label_text, 0, index};
  out.text = text;
  out.size = 26;
  out.colour = dark;
  out.box = box;
  return out;
}

Polygon ground(const PixelBox& box, Role role, Colour colour) {
  return {
      {role, 0, 0},
      {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}},
      colour};
}

Polyline curve(PixelPoint from, PixelPoint to, Colour colour = palette::blue) {
  return {{Role::series, 0, 0}, {from, to}, 4, colour, {}};
}

Markers dots(std::vector<PixelPoint> centres) {
  return {{Role::series_marker, 0, 0}, Marker::circle, std::move(centres), 12, palette::blue};
}

DrawList list_of(std::vector<Primitive> primitives) {
  DrawList list;
  list.width = 1600;
  list.height = 1000;
  list.plots = {{100, 100, 1500, 900}};
  list.primitives = std::move(primitives);
  return list;
}

const PixelBox place{300, 300, 420, 330};

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
  const Polyline through = curve({200, 315}, {600, 315});
  const Polygon backing = ground(place.grown(3), Role::text_backing, {255, 255, 255, 215});
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
  const Polygon backing = ground(place.grown(3), Role::text_backing, {255, 255, 255, 215});
  EXPECT_EQ(markers_under_texts(list_of({dots({{350, 332}}), backing, run("A", place)})).size(),
            1U);
  EXPECT_TRUE(markers_under_texts(list_of({dots({{350, 340}}), backing, run("A", place)})).empty());
  const std::vector<PixelPoint> many(200, {350, 315});
  EXPECT_TRUE(markers_under_texts(list_of({dots(many), backing, run("A", place)})).empty());
  Polyline bar = curve({350, 100}, {350, 800});
  bar.owner.role = Role::error_bar;
  EXPECT_EQ(markers_under_texts(list_of({bar, backing, run("A", place)})).size(), 1U);
}

TEST(Legibility, FindsDataUnderALegend) {
  const Polygon legend = ground({200, 200, 400, 400}, Role::legend_box, paper);
  EXPECT_EQ(data_under_legends(list_of({curve({100, 300}, {500, 300}), legend})).size(), 1U);
  EXPECT_TRUE(data_under_legends(list_of({curve({100, 500}, {500, 500}), legend})).empty());
}

TEST(Contrast, IsThatOfTheGuidelines) {
  EXPECT_NEAR(contrast_ratio({0, 0, 0}, paper), 21, 1e-9);
  EXPECT_NEAR(contrast_ratio(paper, paper), 1, 1e-9);
  // The two greys that every table of the guidelines has: just enough, and just not.
  EXPECT_GE(contrast_ratio({118, 118, 118}, paper), 4.5);
  EXPECT_LT(contrast_ratio({119, 119, 119}, paper), 4.5);
  EXPECT_EQ(laid_on(paper, {0, 0, 0, 128}), (Colour{127, 127, 127}));
}

TEST(Contrast, DarkensColoursUntilLettersInThemAreReadable) {
  for (const Colour colour : {palette::orange, palette::sky_blue, palette::green, palette::yellow,
                              palette::vermilion, palette::purple, palette::grey}) {
    const Colour darker = readable_on_paper(colour);
    EXPECT_GE(contrast_ratio(darker, paper), least_text_contrast);
    EXPECT_LT(contrast_ratio(darker, paper), 5.2) << "no darker than needed";
  }
  EXPECT_EQ(readable_on_paper(palette::blue), palette::blue);
}

TEST(Legibility, FindsFaintTexts) {
  TextRun orange = run("A", place);
  orange.colour = palette::orange;
  EXPECT_EQ(faint_texts(list_of({orange})).size(), 1U);
  EXPECT_TRUE(faint_texts(list_of({run("A", place)})).empty());
  const Polygon shade = ground(place.grown(3), Role::block_fill, {60, 60, 60});
  EXPECT_EQ(faint_texts(list_of({shade, run("A", place)})).size(), 1U);
  const Polygon backing = ground(place.grown(3), Role::text_backing, {255, 255, 255, 215});
  EXPECT_TRUE(faint_texts(list_of({shade, backing, run("A", place)})).empty());
}

TEST(Legibility, FindsFaintLines) {
  constexpr Colour pale{200, 200, 200};
  EXPECT_EQ(faint_lines(list_of({curve({200, 200}, {400, 400}, pale)})).size(), 1U);
  EXPECT_TRUE(faint_lines(list_of({curve({200, 200}, {400, 400}, palette::purple)})).empty());
  EXPECT_TRUE(
      faint_lines(list_of({curve({200, 200}, {400, 400}, pale), curve({0, 0}, {9, 9})})).empty())
      << "samples under their fit";
  Polyline thin = curve({200, 200}, {400, 400}, palette::orange);
  thin.width = 1;
  EXPECT_EQ(faint_lines(list_of({thin})).size(), 1U);
}

TEST(Legibility, FindsSmallLetters) {
  TextRun small = run("A", place);
  small.size = 20;  // at 10 px to the millimetre
  EXPECT_EQ(small_letters(list_of({small}), 7).size(), 1U);
  EXPECT_TRUE(small_letters(list_of({run("A", place)}), 7).empty());
  small.box = place.moved(118, 8);
  EXPECT_TRUE(small_letters(list_of({run("A", place), small}), 7).empty()) << "an index";
}

TEST(Legibility, FindsPanelsWithoutData) {
  Figure figure = examples::plain();
  const Font font;
  EXPECT_TRUE(empty_panels(lay_out(figure, font), figure).empty());
  figure.panels.push_back(figure.panels.front());
  figure.panels.back().series.clear();
  const auto found = empty_panels(lay_out(figure, font), figure);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "panel 2 shows no data");
}

TEST(Legibility, FindsAxesWithoutUnit) {
  Figure figure;
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
  Picture picture{4, 3, std::vector<std::uint8_t>(36, 255)};
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
}  // namespace tribolog::render::legibility
