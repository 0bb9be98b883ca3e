#include "render/figure/diagram.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "render/composition/figure_layout.h"
#include "render/example_diagram.h"
#include "render/png_reading.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::render::diagram_test {
namespace {

figure::DrawList laid_out(const figure::Figure& figure) {
  static const text::Font font;
  return composition::lay_out(figure, font);
}

workers::DrawnFigure drawn(const figure::Figure& figure) {
  return workers::FigureRenderer(1).draw({figure}).at(0);
}

/// Some warning holds each of the words.
void expect_warning(const figure::Figure& figure, const std::string& words) {
  const figure::DrawList list = laid_out(figure);
  const std::vector<std::string> warnings = wording::words(list.warnings);
  EXPECT_TRUE(
      std::any_of(warnings.begin(), warnings.end(),
                  [&](const std::string& one) { return one.find(words) != std::string::npos; }))
      << words << (warnings.empty() ? "; there is none" : "; but " + warnings.front());
}

figure::PixelBox bounds_of(const figure::Primitive& primitive) {
  if (const auto* run = std::get_if<figure::TextRun>(&primitive)) return run->box;
  const auto* line = std::get_if<figure::Polyline>(&primitive);
  const auto& points =
      line != nullptr ? line->points : std::get<figure::Polygon>(primitive).outline;
  figure::PixelBox box{1e9, 1e9, -1e9, -1e9};
  for (const figure::PixelPoint& p : points) {
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x),
           std::max(box.bottom, p.y)};
  }
  return box;
}

TEST(Diagram, OneOfEachKindHasNothingToComplainOf) {
  const workers::DrawnFigure result = drawn(examples::diagram());
  EXPECT_EQ(wording::words(result.error), "");
  EXPECT_TRUE(result.warnings.empty()) << wording::words(result.warnings.front());
}

TEST(Diagram, StaysInsideThePicture) {
  const figure::DrawList list = laid_out(examples::diagram());
  const figure::PixelBox picture{0, 0, static_cast<double>(list.width),
                                 static_cast<double>(list.height)};
  for (const figure::Primitive& one : list.primitives)
    EXPECT_TRUE(picture.contains(bounds_of(one)));
}

TEST(Diagram, DrawsEveryBlockAndWire) {
  const figure::Figure figure = examples::diagram();
  const figure::DrawList list = laid_out(figure);
  const auto has = [&](figure::Role role, std::size_t index) {
    return std::any_of(
        list.primitives.begin(), list.primitives.end(), [&](const figure::Primitive& one) {
          return figure::owner_of(one) == figure::Owner{role, 0, static_cast<int>(index)};
        });
  };
  for (std::size_t i = 0; i < figure.diagram->blocks.size(); ++i)
    EXPECT_TRUE(has(figure::Role::block, i));
  for (std::size_t i = 0; i < figure.diagram->wires.size(); ++i) {
    EXPECT_TRUE(has(figure::Role::wire, i));
    EXPECT_TRUE(has(figure::Role::wire_head, i));
  }
  EXPECT_TRUE(has(figure::Role::branch_dot, 4));
}

TEST(Diagram, GrowsAndShrinksAsAWhole) {
  figure::Figure figure = examples::diagram();
  const figure::DrawList large = laid_out(figure);
  figure.width_px /= 2;
  figure.height_px /= 2;
  const figure::DrawList small = laid_out(figure);
  ASSERT_EQ(small.primitives.size(), large.primitives.size());
  const double rounding_px = 3.0;  // of letters and baselines to whole pixels, twice
  for (std::size_t i = 0; i < small.primitives.size(); ++i) {
    const figure::PixelBox a = bounds_of(small.primitives[i]);
    const figure::PixelBox b = bounds_of(large.primitives[i]);
    EXPECT_NEAR(2 * a.centre().x, b.centre().x, 2 * rounding_px) << i;
    EXPECT_NEAR(2 * a.centre().y, b.centre().y, 2 * rounding_px) << i;
  }
}

TEST(Diagram, HeadsTouchWhatTheyPointAt) {
  const figure::Figure figure = examples::diagram();
  const figure::DrawList list = laid_out(figure);
  const auto bounds = [&](figure::Owner owner) {
    for (const figure::Primitive& one : list.primitives) {
      if (figure::owner_of(one) == owner) return bounds_of(one);
    }
    return figure::PixelBox{};
  };
  const double line_px = 2.5;
  EXPECT_NEAR(bounds({figure::Role::wire_head, 0, 1}).right,
              bounds({figure::Role::block, 0, 2}).left, line_px);
  EXPECT_NEAR(bounds({figure::Role::wire_head, 0, 4}).top,
              bounds({figure::Role::block, 0, 1}).bottom, line_px);
}

TEST(Diagram, ReportsTextThatDoesNotFit) {
  figure::Figure figure = examples::diagram();
  figure.diagram->blocks[5].lines = {"much longer than the block"};
  expect_warning(figure, "'much longer than the block' does not fit into its block");
  figure = examples::diagram();
  figure.diagram->blocks[3].lines = {"σ_{0} + σ_{1}"};
  expect_warning(figure, "does not fit");
}

TEST(Diagram, ReportsTextsThatCollide) {
  figure::Figure figure = examples::diagram();
  figure.diagram->texts.push_back({"other", {142, 75}, figure::TextPlace::centre});
  expect_warning(figure, "'free text' overlaps 'other'");
  figure = examples::diagram();
  figure.diagram->texts[0].at = {60, 26};
  expect_warning(figure, "collides with block 3");
  figure.diagram->texts[0].at = {108, 44};
  expect_warning(figure, "collides with block 'frame'");
  figure.diagram->texts[0].at = {55, 40};
  expect_warning(figure, "lies on a wire");
  for (const figure::DiagramPoint& on_a_line :
       {figure::DiagramPoint{60, 68}, figure::DiagramPoint{140, 60},
        figure::DiagramPoint{80, 70}}) {
    figure.diagram->texts[0].at = on_a_line;
    expect_warning(figure, "lies on a line");
  }
}

TEST(Diagram, ReportsWiresThatGoWrong) {
  figure::Figure figure = examples::diagram();
  figure.diagram->wires[0].points[1].x = 29;
  expect_warning(figure, "wire 1 ends at nothing");
  figure = examples::diagram();
  figure.diagram->wires[4].branch_dots.clear();
  expect_warning(figure, "wire 5 ends at nothing");
  figure = examples::diagram();
  figure.diagram->wires[1].points = {{40, 20}, {82.5, 20}};
  expect_warning(figure, "wire 2 runs through block 3");
  figure.diagram->wires[1].points = {{40, 20}};
  expect_warning(figure, "wire 2 has no length");
}

TEST(Diagram, ReportsWhatLiesOutsideOrOnTop) {
  figure::Figure figure = examples::diagram();
  figure.diagram->blocks[0].centre.x = 3;
  expect_warning(figure, "block 'ω' lies outside the canvas");
  figure = examples::diagram();
  figure.diagram->blocks[5].centre = {91, 24};
  expect_warning(figure, "overlaps");
  figure = examples::diagram();
  figure.diagram->texts[0].at.x = 159;
  expect_warning(figure, "'free text' lies outside the canvas");
}

TEST(Diagram, ReportsLettersThatAreTooSmall) {
  figure::Figure figure = examples::diagram();
  figure.height_px = 500;
  expect_warning(figure, "too small to read");
}

TEST(Diagram, IsDrawnInsteadOfPanels) {
  figure::Figure figure = examples::diagram();
  figure.panels.resize(2);
  EXPECT_EQ(laid_out(figure).primitives.size(), laid_out(examples::diagram()).primitives.size());
  EXPECT_TRUE(laid_out(figure).plots.empty());
  expect_warning(figure, "its panels are not drawn");
}

TEST(Diagram, ThePictureIsRefusedIfABlockOrWireCannotBeSeen) {
  figure::Figure figure = examples::diagram();
  figure.diagram->blocks[5].colour = {255, 255, 255};
  EXPECT_EQ(wording::words(drawn(figure).error), "block 'two' cannot be told from the background");
  figure = examples::diagram();
  figure.diagram->wires[2].colour = {255, 255, 255};
  EXPECT_EQ(wording::words(drawn(figure).error), "wire 3 cannot be told from the background");
}

TEST(Diagram, ThePictureShowsLinesWhereTheyBelong) {
  figure::Figure figure = examples::diagram();
  figure.diagram->wires[1].colour = figure::palette::vermilion;
  const workers::DrawnFigure result = drawn(figure);
  ASSERT_EQ(wording::words(result.error), "");
  const figure::Picture picture = read_png(result.png);
  for (const figure::Primitive& one : laid_out(figure).primitives) {
    const auto* line = std::get_if<figure::Polyline>(&one);
    if (line == nullptr || !(line->owner == figure::Owner{figure::Role::wire, 0, 1})) continue;
    const figure::PixelPoint middle{(line->points[0].x + line->points[1].x) / 2, line->points[0].y};
    EXPECT_EQ(picture.at(static_cast<int>(middle.x), static_cast<int>(std::floor(middle.y))),
              figure::palette::vermilion);
  }
}

TEST(Diagram, SurvivesEmptyAndImpossibleSizes) {
  figure::Figure figure;
  figure.diagram.emplace();
  EXPECT_TRUE(laid_out(figure).primitives.empty());
  figure = examples::diagram();
  figure.height_px = 64;
  expect_warning(figure, "too low");
  for (const double bad : {std::nan(""), 1e300, -HUGE_VAL}) {
    figure = examples::diagram();
    figure.diagram->wires[1].points[0].x = bad;
    expect_warning(figure, "cannot be drawn");
    EXPECT_EQ(wording::words(drawn(figure).error), "");
    figure = examples::diagram();
    figure.diagram->arcs[0].radius = bad;
    expect_warning(figure, "cannot be drawn");
  }
  figure = examples::diagram();
  figure.diagram->width = figure.diagram->height = 0;
  EXPECT_FALSE(laid_out(figure).warnings.empty());
}

}  // namespace
}  // namespace tribolog::render::diagram_test
