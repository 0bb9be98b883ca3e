#include <cmath>

#include <gtest/gtest.h>

#include "history/reference_line.h"
#include "statistics/distributions.h"
#include "statistics/random_stream.h"

namespace tribolog::history::slow_drift_test {
namespace {

struct Series {
  std::vector<SeriesPoint> points;
  std::vector<double> days;
};

/// One calibration every 30 days: level 2, noise of 0.01, a change per day, and per kelvin.
Series series(std::uint64_t seed, std::size_t count, double per_day, double noise = 0.01,
              double per_K = 0) {
  statistics::RandomStream random(seed, 3);
  Series s;
  for (std::size_t k = 0; k < count; ++k) {
    const double day = 20000 + 30.0 * static_cast<double>(k);
    const double temperature_C = 25 + 5 * std::sin(2.1 * static_cast<double>(k));
    const double value =
        2 + per_day * (day - 20000) + per_K * (temperature_C - 25) + noise * random.normal();
    s.points.push_back({value, noise, temperature_C});
    s.days.push_back(day);
  }
  return s;
}

TEST(SlowDrift, IsRecoveredWithoutNoise) {
  const Series s = series(1, 20, -1e-4, 0);
  const auto drift = find_slow_drift(s.points, s.days, false, 9);
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->per_day, -1e-4, 1e-12);
  EXPECT_NEAR(drift->at_start, 2, 1e-9);
  EXPECT_LT(drift->score, 0);
  EXPECT_EQ(drift->visible, fewest_for_drift - 1);
}

TEST(SlowDrift, IsToldApartFromTemperature) {
  const Series s = series(1, 20, 1e-4, 0, 0.02);
  const auto drift = find_slow_drift(s.points, s.days, true, 9);
  ASSERT_TRUE(drift);
  EXPECT_NEAR(drift->per_day, 1e-4, 1e-10);
  Series warming = s;
  for (std::size_t k = 0; k < warming.points.size(); ++k) {
    warming.points[k].temperature_C = 20 + static_cast<double>(k);
  }
  EXPECT_FALSE(find_slow_drift(warming.points, warming.days, true, 9)) << "it rose along with time";
}

TEST(SlowDrift, TheSlopesIntervalHoldsTheTruth) {
  constexpr int runs = 400;
  int inside = 0, found = 0;
  for (int seed = 1; seed <= runs; ++seed) {
    const Series s = series(static_cast<std::uint64_t>(seed), 24, 1e-4);
    const auto drift = find_slow_drift(s.points, s.days, false, 1);
    if (!drift) continue;
    ++found;
    const double half_width = statistics::student_t_975(drift->freedom) * drift->standard_error;
    inside += std::abs(drift->per_day - 1e-4) <= half_width ? 1 : 0;
    EXPECT_GE(drift->visible + 1, fewest_for_drift);
    EXPECT_LT(drift->visible, s.points.size());
  }
  EXPECT_GT(found, runs * 0.99);
  EXPECT_GT(inside, found * 0.92);
  EXPECT_LT(inside, found * 0.98);
}

TEST(SlowDrift, IsAsSeldomToldWithoutOneAsStated) {
  constexpr int runs = 20'000;
  int told = 0;
  for (int seed = 1; seed <= runs; ++seed) {
    const Series s = series(static_cast<std::uint64_t>(seed), 20, 0);
    told += find_slow_drift(s.points, s.days, false, 1) ? 1 : 0;
  }
  // 30 expected of independent noise.
  EXPECT_GT(told, 12);
  EXPECT_LT(told, 50);
}

TEST(SlowDrift, NeedsEnoughCalibrationsAndTime) {
  const Series few = series(1, fewest_for_drift - 1, 1e-2);
  EXPECT_FALSE(find_slow_drift(few.points, few.days, false, 1));
  Series at_once = series(1, 20, 1e-2);
  for (double& day : at_once.days) day = 20000;
  EXPECT_FALSE(find_slow_drift(at_once.points, at_once.days, false, 1));
  Series same = series(1, 20, 0, 0);
  EXPECT_FALSE(find_slow_drift(same.points, same.days, false, 1));
}

}  // namespace
}  // namespace tribolog::history::slow_drift_test
