#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "render/figure/draw_list.h"
#include "render/vtk/strip_builder.h"

namespace tribolog::render::dashes_test {
namespace {

TEST(Dashes, RunOnAroundCorners) {
  const auto dashes = figure::cut_into_dashes({{0, 0}, {15, 0}, {15, 25}}, {10, 10});
  ASSERT_EQ(dashes.size(), 2U);
  EXPECT_EQ(dashes[0], (std::vector<figure::PixelPoint>{{0, 0}, {10, 0}}));
  EXPECT_EQ(dashes[1], (std::vector<figure::PixelPoint>{{15, 5}, {15, 15}}));
}

TEST(Dashes, BendWithTheLine) {
  const auto dashes = figure::cut_into_dashes({{0, 0}, {5, 0}, {5, 5}}, {8, 8});
  ASSERT_EQ(dashes.size(), 1U);
  EXPECT_EQ(dashes[0], (std::vector<figure::PixelPoint>{{0, 0}, {5, 0}, {5, 3}}));
}

TEST(Dashes, DifferBetweenStyles) {
  EXPECT_TRUE(figure::dash_lengths(figure::LineStyle::solid, 3).empty());
  EXPECT_EQ(figure::dash_lengths(figure::LineStyle::dash, 3).size(), 2U);
  EXPECT_EQ(figure::dash_lengths(figure::LineStyle::dash_dot, 3).size(), 4U);
  EXPECT_EQ(figure::dash_lengths(figure::LineStyle::dash_dot_dot, 3).size(), 6U);
  EXPECT_LT(figure::dash_lengths(figure::LineStyle::dot, 3)[0],
            figure::dash_lengths(figure::LineStyle::dash, 3)[0]);
}

/// Colour in a strip of quads, each split into two triangles: their area by their mean cover.
double ink(const std::vector<vtk::StripPoint>& p) {
  double sum = 0;
  for (std::size_t i = 2; i < p.size(); ++i) {
    const figure::PixelPoint a = p[i - 2].at;
    const figure::PixelPoint b = p[i - 1].at;
    const figure::PixelPoint c = p[i].at;
    const double cover = (p[i - 2].cover + p[i - 1].cover + p[i].cover) / 3;
    sum += cover * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
  }
  return sum;
}

TEST(StripBuilder, GivesALineItsWidthAndPartsNoTies) {
  vtk::StripBuilder strip;
  strip.add(figure::Polyline{{}, {{0, 0}, {100, 0}}, 4, figure::palette::black, {}});
  EXPECT_NEAR(ink(strip.points()), 400, 0.5) << "what fades outside of the edges is missing inside";
  strip.add(figure::Polyline{{}, {{0, 500}, {0, 700}}, 2, figure::palette::black, {}});
  EXPECT_NEAR(ink(strip.points()), 800, 1) << "nothing is filled between the two lines";
}

TEST(StripBuilder, RoundsASharpCorner) {
  vtk::StripBuilder strip;
  strip.add(figure::Polyline{{}, {{0, 0}, {100, 0}, {0, 10}}, 10, figure::palette::black, {}});
  double rightmost = 0;
  for (const vtk::StripPoint& p : strip.points()) {
    if (p.cover == 1) rightmost = std::max(rightmost, p.at.x + 0.5);
  }
  EXPECT_NEAR(rightmost, 105, 0.5) << "half the width beyond the corner: neither notch nor spike";
}

// A line thinner than a pixel is paler, not thinner than what a pixel can show.
TEST(StripBuilder, KeepsTheInkOfThinLinesPolygonsAndBands) {
  vtk::StripBuilder thin;
  thin.add(figure::Polyline{{}, {{0, 0}, {60, 80}}, 0.5, figure::palette::black, {}});
  EXPECT_NEAR(ink(thin.points()), 50, 0.5);
  for (const bool clockwise : {true, false}) {
    std::vector<figure::PixelPoint> square{{10, 10}, {30, 10}, {30, 30}, {10, 30}};
    if (!clockwise) std::reverse(square.begin(), square.end());
    vtk::StripBuilder filled;
    filled.add(figure::Polygon{{}, square, figure::palette::black});
    EXPECT_NEAR(ink(filled.points()), 400, 1) << clockwise;
  }
  vtk::StripBuilder band;
  band.add(figure::Ribbon{
      {}, {{0, 0}, {50, 0}, {100, 0}}, {{0, 7}, {50, 7}, {100, 7}}, figure::palette::black});
  EXPECT_NEAR(ink(band.points()), 700, 1);
}

TEST(StripBuilder, IgnoresRepeatedPoints) {
  vtk::StripBuilder strip;
  strip.add(figure::Polyline{{}, {{5, 5}, {5, 5}, {5, 5}}, 4, figure::palette::black, {}});
  EXPECT_TRUE(strip.points().empty());
}

}  // namespace
}  // namespace tribolog::render::dashes_test
