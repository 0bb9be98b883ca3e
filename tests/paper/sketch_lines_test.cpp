#include <cmath>

#include <gtest/gtest.h>

#include "paper/drawings/paper_drawings.h"

namespace tribolog::paper::sketch_lines_test {
namespace {

TEST(BentBristle, IsClampedAtItsRootAndDeflectedAtItsTip) {
  const auto points = drawings::bent_bristle({10, 20}, 8, -3);
  EXPECT_EQ(points.front(), (render::figure::DiagramPoint{10, 20}));
  EXPECT_DOUBLE_EQ(points.back().x, 7);
  EXPECT_DOUBLE_EQ(points.back().y, 28);
  const double first_slope = (points[1].x - points[0].x) / (points[1].y - points[0].y);
  const double last_slope = -1.5 * 3 / 8;  // of a cantilever with a force at its tip
  EXPECT_LT(std::abs(first_slope), 0.05 * std::abs(last_slope));
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LE(points[i].x, points[i - 1].x);
}

TEST(BentBristle, IsStraightAtRest) {
  for (const auto& point : drawings::bent_bristle({10, 20}, 8, 0)) EXPECT_EQ(point.x, 10);
}

}  // namespace
}  // namespace tribolog::paper::sketch_lines_test
