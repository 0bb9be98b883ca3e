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

/// Area of a strip of quads, each split into two triangles.
double area(const std::vector<figure::PixelPoint>& p) {
  double sum = 0;
  for (std::size_t i = 2; i < p.size(); ++i) {
    sum += std::abs((p[i - 1].x - p[i - 2].x) * (p[i].y - p[i - 2].y) -
                    (p[i].x - p[i - 2].x) * (p[i - 1].y - p[i - 2].y)) /
           2;
  }
  return sum;
}

TEST(StripBuilder, GivesALineItsWidthAndPartsNoTies) {
  vtk::StripBuilder strip;
  strip.add(figure::Polyline{{}, {{0, 0}, {100, 0}}, 4, figure::palette::black, {}});
  EXPECT_NEAR(area(strip.points()), 400, 1e-9);
  strip.add(figure::Polyline{{}, {{0, 500}, {0, 700}}, 2, figure::palette::black, {}});
  EXPECT_NEAR(area(strip.points()), 800, 1e-9) << "nothing is filled between the two lines";
}

TEST(StripBuilder, RoundsASharpCorner) {
  vtk::StripBuilder strip;
  strip.add(figure::Polyline{{}, {{0, 0}, {100, 0}, {0, 10}}, 10, figure::palette::black, {}});
  double rightmost = 0;
  for (const figure::PixelPoint& p : strip.points()) rightmost = std::max(rightmost, p.x);
  EXPECT_NEAR(rightmost, 105, 0.5) << "half the width beyond the corner: neither notch nor spike";
}

TEST(StripBuilder, IgnoresRepeatedPoints) {
  vtk::StripBuilder strip;
  strip.add(figure::Polyline{{}, {{5, 5}, {5, 5}, {5, 5}}, 4, figure::palette::black, {}});
  EXPECT_TRUE(strip.points().empty());
}

}  // namespace
}  // namespace tribolog::render::dashes_test
