#include <algorithm>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "render/layout/polyline.h"

namespace tribolog::render::polyline_simplifier_test {
namespace {

using Line = std::vector<figure::PixelPoint>;

double distance(figure::PixelPoint p, figure::PixelPoint a, figure::PixelPoint b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double t =
      square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// Farthest that any spot of `from` (sampled finely) is from `to`.
double farthest(const Line& from, const Line& to) {
  double worst = 0;
  for (std::size_t i = 1; i < from.size(); ++i) {
    const double length = std::hypot(from[i].x - from[i - 1].x, from[i].y - from[i - 1].y);
    const int steps = static_cast<int>(length / 0.1) + 1;
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const figure::PixelPoint p{from[i - 1].x + t * (from[i].x - from[i - 1].x),
                                 from[i - 1].y + t * (from[i].y - from[i - 1].y)};
      double nearest = 1e9;
      for (std::size_t j = 1; j < to.size(); ++j) {
        nearest = std::min(nearest, distance(p, to[j - 1], to[j]));
      }
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

Line sampled(int count, double (*x)(double), double (*y)(double)) {
  Line out;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    out.push_back({x(t), y(t)});
  }
  return out;
}

void expect_same_picture(const Line& original, const Line& simple) {
  constexpr double rounding = 1e-9;
  EXPECT_LE(farthest(original, simple), layout::simplification_tolerance_px + rounding);
  EXPECT_LE(farthest(simple, original), layout::simplification_tolerance_px + rounding);
  EXPECT_EQ(simple.front(), original.front());
  EXPECT_EQ(simple.back(), original.back());
}

TEST(PolylineSimplifier, KeepsASmoothLoopWithAQuarterPixel) {
  const Line loop = sampled(
      5000, [](double t) { return 700 + 600 * std::cos(6.28 * t); },
      [](double t) { return 400 + 300 * std::sin(6.28 * t + 0.4); });
  const Line simple = layout::simplified(loop);
  expect_same_picture(loop, simple);
  EXPECT_LT(simple.size(), 300U);
}

TEST(PolylineSimplifier, KeepsSpikesAndReversals) {
  Line spikes;
  for (int i = 0; i < 400; ++i) {
    spikes.push_back({i * 0.5, i % 37 == 0 ? 300.0 : 10.0 + (i % 5) * 0.01});
  }
  const Line simple = layout::simplified(spikes);
  expect_same_picture(spikes, simple);
  EXPECT_LT(simple.size(), spikes.size() / 4);
}

TEST(PolylineSimplifier, TurnsNoiseIntoOneStrokeAColumn) {
  Line noise;
  for (int i = 0; i < 20'000; ++i) {
    noise.push_back({i * 0.005, 50 + 40 * std::sin(i * 12.9898) * std::cos(i * 4.1)});
  }
  const Line simple = layout::simplified(noise);
  EXPECT_LE(simple.size(), 2U * 4 * 100 + 4);
  for (const figure::PixelPoint& p : noise) {
    double nearest = 1e9;
    for (std::size_t j = 1; j < simple.size(); ++j) {
      nearest = std::min(nearest, distance(p, simple[j - 1], simple[j]));
    }
    ASSERT_LE(nearest, 2 * layout::simplification_tolerance_px);
  }
}

TEST(PolylineSimplifier, KeepsShortLines) {
  EXPECT_EQ(layout::simplified({}).size(), 0U);
  EXPECT_EQ(layout::simplified({{1, 2}}).size(), 1U);
  EXPECT_EQ(layout::simplified({{1, 2}, {1, 90}}).size(), 2U);
  EXPECT_EQ(layout::simplified({{0, 0}, {50, 0}, {10, 0}}).size(), 3U) << "goes back on itself";
}

TEST(LineCollector, CutsAtTheBoxAndBreaksOutside) {
  layout::LineCollector collector({0, 0, 100, 100});
  for (const figure::PixelPoint& p : Line{{-50, 50}, {50, 50}, {50, 150}, {60, 150}, {60, 50}}) {
    collector.add(p);
  }
  const auto lines = collector.take();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].front(), (figure::PixelPoint{0, 50}));
  EXPECT_EQ(lines[0].back(), (figure::PixelPoint{50, 100}));
  EXPECT_EQ(lines[1].front(), (figure::PixelPoint{60, 100}));
}

TEST(LineCollector, DrawsALineThatOnlyCrosses) {
  layout::LineCollector collector({0, 0, 100, 100});
  collector.add({-1e9, 50});
  collector.add({1e9, 50});
  const auto lines = collector.take();
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(lines[0].front().x, 0, 1e-6);
  EXPECT_NEAR(lines[0].back().x, 100, 1e-6);
}

}  // namespace
}  // namespace tribolog::render::polyline_simplifier_test
