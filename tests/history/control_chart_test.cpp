#include "history/control_chart.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "statistics/distributions.h"
#include "statistics/random_stream.h"

namespace tribolog::history::control_chart_test {
namespace {

constexpr double sigma = 0.01;

/// Values about 1 with the scatter sigma, half of its variance stated.
std::vector<SeriesPoint> series(std::uint64_t seed, std::size_t n,
                                const std::function<double(std::size_t)>& shift) {
  std::vector<SeriesPoint> points;
  statistics::RandomStream random(seed, 3);
  const double part = sigma / std::sqrt(2.0);
  for (std::size_t k = 0; k < n; ++k) {
    points.push_back({1 + shift(k) + part * random.normal() + part * random.normal(), part, 0});
  }
  return points;
}

TEST(NormalScore, IsTheNormalNumberOfTheSameRank) {
  // Tables of Student's t: 2.571 is the 97.5 % quantile of 5 degrees, 636.6 the 99.95 % one of 1.
  EXPECT_NEAR(statistics::normal_score(2.5706, 5), 1.95996, 1e-4);
  EXPECT_NEAR(statistics::normal_score(636.619, 1), 3.29053, 1e-4);
  EXPECT_NEAR(statistics::normal_score(-2.5706, 5), -1.95996, 1e-4);
  EXPECT_EQ(statistics::normal_score(0, 3), 0);
  EXPECT_NEAR(statistics::normal_score(1.7, 1e7), 1.7, 1e-5);
  EXPECT_GT(statistics::normal_score(1e300, 3), 30);
}

TEST(ReferenceLine, FindsLevelAndScatterBeyondTheIntervals) {
  const auto points = series(1, 4000, [](std::size_t) { return 0.0; });
  std::vector<std::size_t> all(points.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  const auto line = ReferenceLine::fitted(points, all, false);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->level, 1, 4 * sigma / std::sqrt(4000.0));
  EXPECT_NEAR(line->scatter(), sigma, 0.04 * sigma);
  EXPECT_NEAR(std::sqrt(line->between_variance), sigma / std::sqrt(2.0), 0.06 * sigma);
  EXPECT_NEAR(std::sqrt(line->level_variance), sigma / std::sqrt(4000.0), 0.1 * sigma / 63);
}

TEST(ReferenceLine, ADriftHardlyWidensTheScatter) {
  const auto points =
      series(2, 300, [](std::size_t k) { return 0.2 * sigma * static_cast<double>(k); });
  std::vector<std::size_t> all(points.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  EXPECT_NEAR(ReferenceLine::fitted(points, all, false)->scatter(), sigma, 0.15 * sigma)
      << "about its mean it is 17 sigma";
}

TEST(ReferenceLine, WideIntervalsWeighLess) {
  const std::vector<SeriesPoint> points{{1, 0.1, 0}, {1, 0.1, 0}, {1, 0.1, 0}, {2, 10, 0}};
  const auto line = ReferenceLine::fitted(points, {0, 1, 2, 3}, false);
  EXPECT_NEAR(line->level, 1, 0.01);
}

// An error of 5 % that all calibrations share is in every interval and in no difference.
TEST(ReferenceLine, AnErrorThatAllShareHidesNoChange) {
  auto points = series(1, 400, [](std::size_t) { return 0.0; });
  for (SeriesPoint& p : points) p.standard_error = 0.05;
  std::vector<std::size_t> all(points.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  const auto line = ReferenceLine::fitted(points, all, false);
  EXPECT_NEAR(line->scatter(), sigma, 0.15 * sigma);
  EXPECT_NEAR(line->standardised({1 + 3 * sigma, 0.05, 0}), 3, 0.5);
}

TEST(ReferenceLine, SlopeComesBack) {
  std::vector<SeriesPoint> points;
  for (int k = 0; k < 8; ++k) points.push_back({5 - 0.05 * (20 + k - 25), 1e-3, 20.0 + k});
  const auto line = ReferenceLine::fitted(points, {0, 1, 2, 3, 4, 5, 6, 7}, true);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->slope_per_K, -0.05, 1e-9);
  EXPECT_NEAR(line->at(25).value, 5, 1e-9);
  for (SeriesPoint& p : points) p.temperature_C = 20;
  EXPECT_FALSE(ReferenceLine::fitted(points, {0, 1, 2, 3, 4, 5, 6, 7}, true))
      << "one temperature tells no slope";
}

TEST(ReferenceLine, KnowsLittleFarFromItsTemperatures) {
  std::vector<SeriesPoint> points;
  for (int k = 0; k < 8; ++k) {
    points.push_back({5 + 0.01 * (k % 2), 5e-3, 20 + 0.3 * (k % 3)});
  }
  const auto line = ReferenceLine::fitted(points, {0, 1, 2, 3, 4, 5, 6, 7}, true);
  EXPECT_LT(std::abs(line->standardised({5.2, 5e-3, 40})), 2);
  EXPECT_GT(line->standardised({5.2, 5e-3, 20.3}), 10);
}

TEST(ControlChart, SaysNothingOfFewCalibrations) {
  for (const std::size_t n : {0, 1, 3, 6}) {
    const ControlChart chart =
        make_control_chart(series(1, n, [](std::size_t k) { return k > 2 ? 1.0 : 0.0; }), {});
    EXPECT_EQ(chart.judged(), 0U);
    EXPECT_EQ(chart.warning(), nullptr);
  }
  const auto seven = make_control_chart(series(1, 7, [](std::size_t) { return 0.0; }), {});
  EXPECT_EQ(seven.judged(), 1U);
}

TEST(ControlChart, DatesAStep) {
  int exact = 0, timely = 0;
  constexpr int runs = 100;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const ControlChart chart = make_control_chart(
        series(seed, 30, [](std::size_t k) { return k >= 15 ? 4 * sigma : 0; }), {});
    ASSERT_NE(chart.warning(), nullptr) << seed;
    EXPECT_EQ(chart.warning()->direction, 1);
    if (chart.warning()->alarm >= 16 && chart.warning()->alarm <= 22) ++timely;
    if (std::abs(static_cast<int>(chart.warning()->start) - 15) <= 1) ++exact;
    EXPECT_NEAR(chart.reference->level, 1, 1.6 * sigma) << "of what lay before";
  }
  EXPECT_GE(timely, 95) << "one calibration alone is no alarm, eight are enough";
  EXPECT_GE(exact, 93);
}

TEST(ControlChart, RisingAndFallingAreMirrorImages) {
  auto up = series(4, 40, [](std::size_t k) { return k >= 20 ? 3 * sigma : 0; });
  auto down = up;
  for (SeriesPoint& p : down) p.value = 2 - p.value;
  const ControlChart a = make_control_chart(up, {});
  const ControlChart b = make_control_chart(down, {});
  ASSERT_EQ(a.excursions.size(), b.excursions.size());
  EXPECT_EQ(a.excursions.front().direction, -b.excursions.front().direction);
  EXPECT_EQ(a.excursions.front().start, b.excursions.front().start);
  for (std::size_t k = 0; k < up.size(); ++k) {
    EXPECT_NEAR(a.points[k].above, b.points[k].below, 1e-6);
  }
}

TEST(ControlChart, UnitsDoNotMatter) {
  auto points = series(6, 40, [](std::size_t k) { return k >= 20 ? 3 * sigma : 0; });
  const ControlChart a = make_control_chart(points, {});
  for (SeriesPoint& p : points) {
    p.value *= 1000;
    p.standard_error *= 1000;
  }
  const ControlChart b = make_control_chart(points, {});
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_NEAR(a.points[k].score, b.points[k].score, 1e-6);
  }
}

TEST(ControlChart, ALubricationThatBroughtItBackIsOver) {
  int recovered = 0, dated = 0;
  constexpr int runs = 100;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const ControlChart chart = make_control_chart(
        series(seed, 45, [](std::size_t k) { return k >= 15 && k < 27 ? 5 * sigma : 0; }), {});
    ASSERT_FALSE(chart.excursions.empty());
    if (chart.warning() != nullptr) continue;
    ++recovered;
    ASSERT_TRUE(chart.excursions.front().back);
    if (std::abs(static_cast<double>(*chart.excursions.front().back) - 27) <= 1) ++dated;
  }
  EXPECT_GE(recovered, 98);
  EXPECT_GE(dated, 90);
}

TEST(ControlChart, AStandingChangeIsNotTakenBack) {
  int standing = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const ControlChart chart = make_control_chart(
        series(seed, 60, [](std::size_t k) { return k >= 15 ? 4 * sigma : 0; }), {});
    if (chart.warning() != nullptr && chart.excursions.size() == 1) ++standing;
  }
  EXPECT_GE(standing, 98);
}

TEST(ControlChart, OneWildCalibrationIsNoAlarm) {
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const ControlChart chart = make_control_chart(
        series(seed, 30, [](std::size_t k) { return k == 15 ? 50 * sigma : 0; }), {});
    if (!chart.excursions.empty()) ++alarms;
  }
  EXPECT_LE(alarms, 2) << "where luck had carried the sum half the way before";
}

TEST(ControlChart, TwoWildCalibrationsStandApartAndSpoilNoReference) {
  int apart = 0;
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const ControlChart chart = make_control_chart(
        series(seed, 30, [](std::size_t k) { return k == 15 || k == 16 ? 50 * sigma : 0; }), {});
    ASSERT_TRUE(chart.reference);
    for (std::size_t k = 0; k < chart.points.size(); ++k) {
      if (chart.points[k].is_apart) ++(k == 15 || k == 16 ? apart : others);
    }
    if (!chart.excursions.empty()) continue;
    EXPECT_LT(chart.reference->scatter(), 2 * sigma) << seed;
  }
  EXPECT_GE(apart, 195);
  EXPECT_LE(others, 1);
}

TEST(ControlChart, ValuesThatAreAllTheSameAreQuiet) {
  const std::vector<SeriesPoint> same(20, SeriesPoint{3.5, 0, 0});
  const ControlChart chart = make_control_chart(same, {});
  EXPECT_TRUE(chart.excursions.empty());
  EXPECT_EQ(chart.judged(), 14U);
  const ControlChart zero = make_control_chart(std::vector<SeriesPoint>(20), {});
  EXPECT_TRUE(zero.excursions.empty());
}

}  // namespace
}  // namespace tribolog::history::control_chart_test
