#include "render/figure/diagram.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "render/composition/figure_layout.h"
#include "render/example_diagram.h"
#include "render/png_reading.h"
#include "render/workers/renderer.h"

namespace tribolog::render {
namespace {

DrawList laid_out(const Figure& figure) {
  static const Font font;
  return lay_out(figure, font);
}

DrawnFigure drawn(const Figure& figure) { return FigureRenderer(1).draw({figure}).at(0); }

/// Some warning holds each of the words.
void expect_warning(const Figure& figure, const std::string& words) {
  const DrawList list = laid_out(figure);
  EXPECT_TRUE(
      std::any_of(list.warnings.begin(), list.warnings.end(),
                  [&](const std::string& one) { return one.find(words) != std::string::npos; }))
      << words << (list.warnings.empty() ? "; there is none" : "; but " + list.warnings.front());
}

PixelBox bounds_of(const Primitive& primitive) {
  if (const auto* run = std::get_if<TextRun>(&primitive)) return run->box;
  const auto* line = std::get_if<Polyline>(&primitive);
  const auto& points = line != nullptr ? line->points : std::get<Polygon>(primitive).outline;
  PixelBox box{1e9, 1e9, -1e9, -1e9};
  for (const PixelPoint& p : points) {
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x),
           std::max(box.bottom, p.y)};
  }
  return box;
}

TEST(Diagram, OneOfEachKindHasNothingToComplainOf) {
  const DrawnFigure result = drawn(examples::diagram());
  EXPECT_EQ(result.error, "");
  EXPECT_TRUE(result.warnings.empty()) << result.warnings.front();
}

TEST(Diagram, StaysInsideThePicture) {
  const DrawList list = laid_out(examples::diagram());
  const PixelBox picture{0, 0, static_cast<double>(list.width), static_cast<double>(list.height)};
  for (const Primitive& one : list.primitives) EXPECT_TRUE(picture.contains(bounds_of(one)));
}

TEST(Diagram, DrawsEveryBlockAndWire) {
  const Figure figure = examples::diagram();
  const DrawList list = laid_out(figure);
  const auto has = [&](Role role, std::size_t index) {
    return std::any_of(list.primitives.begin(), list.primitives.end(), [&](const Primitive& one) {
      return owner_of(one) == Owner{role, 0, static_cast<int>(index)};
    });
  };
  for (std::size_t i = 0; i < figure.diagram->blocks.size(); ++i) EXPECT_TRUE(has(Role::block, i));
  for (std::size_t i = 0; i < figure.diagram->wires.size(); ++i) {
    EXPECT_TRUE(has(Role::wire, i));
    EXPECT_TRUE(has(Role::wire_head, i));
  }
  EXPECT_TRUE(has(Role::branch_dot, 4));
}

TEST(Diagram, GrowsAndShrinksAsAWhole) {
  Figure figure = examples::diagram();
  const DrawList large = laid_out(figure);
  figure.width_px /= 2;
  figure.height_px /= 2;
  const DrawList small = laid_out(figure);
  ASSERT_EQ(small.primitives.size(), large.primitives.size());
  const double rounding_px = 3.0;  // of letters and baselines to whole pixels, twice
  for (std::size_t i = 0; i < small.primitives.size(); ++i) {
    const PixelBox a = bounds_of(small.primitives[i]);
    const PixelBox b = bounds_of(large.primitives[i]);
    EXPECT_NEAR(2 * a.centre().x, b.centre().x, 2 * rounding_px) << i;
    EXPECT_NEAR(2 * a.centre().y, b.centre().y, 2 * rounding_px) << i;
  }
}

TEST(Diagram, HeadsTouchWhatTheyPointAt) {
  const Figure figure = examples::diagram();
  const DrawList list = laid_out(figure);
  const auto bounds = [&](Owner owner) {
    for (const Primitive& one : list.primitives) {
      if (owner_of(one) == owner) return bounds_of(one);
    }
    return PixelBox{};
  };
  const double line_px = 2.5;
  EXPECT_NEAR(bounds({Role::wire_head, 0, 1}).right, bounds({Role::block, 0, 2}).left, line_px);
  EXPECT_NEAR(bounds({Role::wire_head, 0, 4}).top, bounds({Role::block, 0, 1}).bottom, line_px);
}

TEST(Diagram, ReportsTextThatDoesNotFit) {
  Figure figure = examples::diagram();
  figure.diagram->blocks[5].lines = {"much longer than the block"};
  expect_warning(figure, "'much longer than the block' does not fit into its block");
  figure = examples::diagram();
  figure.diagram->blocks[3].lines = {"σ_{0} + σ_{1}"};
  expect_warning(figure, "does not fit");
}

TEST(Diagram, ReportsTextsThatCollide) {
  Figure figure = examples::diagram();
  figure.diagram->texts.push_back({"other", {142, 75}, TextPlace::centre});
  expect_warning(figure, "'free text' overlaps 'other'");
  figure = examples::diagram();
  figure.diagram->texts[0].at = {60, 26};
  expect_warning(figure, "collides with block 3");
  figure.diagram->texts[0].at = {108, 44};
  expect_warning(figure, "collides with block 'frame'");
  figure.diagram->texts[0].at = {55, 40};
  expect_warning(figure, "lies on a wire");
  for (const DiagramPoint& on_a_line :
       {DiagramPoint{60, 68}, DiagramPoint{140, 60}, DiagramPoint{80, 70}}) {
    figure.diagram->texts[0].at = on_a_line;
    expect_warning(figure, "lies on a line");
  }
}

TEST(Diagram, ReportsWiresThatGoWrong) {
  Figure figure = examples::diagram();
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
  Figure figure = examples::diagram();
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
  Figure figure = examples::diagram();
  figure.height_px = 500;
  expect_warning(figure, "too small to read");
}

TEST(Diagram, IsDrawnInsteadOfPanels) {
  Figure figure = examples::diagram();
  figure.panels.resize(2);
  EXPECT_EQ(laid_out(figure).primitives.size(), laid_out(examples::diagram()).primitives.size());
  EXPECT_TRUE(laid_out(figure).plots.empty());
  expect_warning(figure, "its panels are not drawn");
}

TEST(Diagram, ThePictureIsRefusedIfABlockOrWireCannotBeSeen) {
  Figure figure = examples::diagram();
  figure.diagram->blocks[5].colour = {255, 255, 255};
  EXPECT_EQ(drawn(figure).error, "block 'two' cannot be told from the background");
  figure = examples::diagram();
  figure.diagram->wires[2].colour = {255, 255, 255};
  EXPECT_EQ(drawn(figure).error, "wire 3 cannot be told from the background");
}

TEST(Diagram, ThePictureShowsLinesWhereTheyBelong) {
  Figure figure = examples::diagram();
  figure.diagram->wires[1].colour = palette::vermilion;
  const DrawnFigure result = drawn(figure);
  ASSERT_EQ(result.error, "");
  const Picture picture = read_png(result.png);
  for (const Primitive& one : laid_out(figure).primitives) {
    const auto* line = std::get_if<Polyline>(&one);
    if (line == nullptr || !(line->owner == Owner{Role::wire, 0, 1})) continue;
    const PixelPoint middle{(line->points[0].x + line->points[1].x) / 2, line->points[0].y};
    EXPECT_EQ(picture.at(static_cast<int>(middle.x), static_cast<int>(std::floor(middle.y))),
              palette::vermilion);
  }
}

TEST(Diagram, SurvivesEmptyAndImpossibleSizes) {
  Figure figure;
  figure.diagram.emplace();
  EXPECT_TRUE(laid_out(figure).primitives.empty());
  figure = examples::diagram();
  figure.height_px = 64;
  expect_warning(figure, "too low");
  for (const double bad : {std::nan(""), 1e300, -HUGE_VAL}) {
    figure = examples::diagram();
    figure.diagram->wires[1].points[0].x = bad;
    expect_warning(figure, "cannot be drawn");
    EXPECT_EQ(drawn(figure).error, "");
    figure = examples::diagram();
    figure.diagram->arcs[0].radius = bad;
    expect_warning(figure, "cannot be drawn");
  }
  figure = examples::diagram();
  figure.diagram->width = figure.diagram->height = 0;
  EXPECT_FALSE(laid_out(figure).warnings.empty());
}

}  // namespace
}  // namespace tribolog::render
