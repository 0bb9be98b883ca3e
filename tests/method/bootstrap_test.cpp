// The pieces of the bootstrap: what is drawn has the spread that it should.

#include "method/intervals/bootstrap.h"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "statistics/distributions.h"
#include "statistics/order_statistics.h"
#include "statistics/random_stream.h"

namespace tribolog::bootstrap::bootstrap_test {
namespace {

constexpr int draws = 20000;

TEST(BlockDraw, CountsAreThoseOfAsManyDrawsAsBlocks) {
  statistics::RandomStream random(1, 1);
  for (int k = 0; k < 100; ++k) {
    const std::vector<double> counts = statistics::centred_counts(random, 9);
    EXPECT_NEAR(std::accumulate(counts.begin(), counts.end(), 0.0), 0, 1e-12);
    for (const double c : counts) EXPECT_GE(c, -1);
  }
}

TEST(BlockDraw, IntervalOfAMeanOfNineIsItsTInterval) {
  const std::vector<double> values{3, 1, 4, 1.5, 5, 9, 2, 6, 5.3};
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / 9;
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  const double exact = statistics::student_t_975(8) * std::sqrt(squares / 8 / 9);
  statistics::RandomStream random(2, 1);
  std::vector<double> means;
  for (int k = 0; k < draws; ++k) {
    means.push_back(
        mean + statistics::few_blocks_scale(random, 8) *
                   statistics::resampled_mean_shift(values, statistics::centred_counts(random, 9)));
  }
  const statistics::Estimate interval = statistics::percentile_interval(mean, means);
  // Nine values are no normal distribution: the resampled means have its shape to a few percent.
  EXPECT_NEAR(interval.half_width() / exact, 1, 0.06);
}

TEST(BlockDraw, ScaleHasTheTailsOfStudentsT) {
  for (const double freedom : {1.5, 3.0, 8.0, 40.0}) {
    statistics::RandomStream random(3, static_cast<std::uint64_t>(10 * freedom));
    int outside = 0;
    for (int k = 0; k < draws; ++k) {
      const double t = statistics::few_blocks_scale(random, freedom) * random.normal();
      outside += std::abs(t) > statistics::student_t_975(freedom) ? 1 : 0;
    }
    // 5 % of the draws; 4 standard errors are 0.6 %.
    EXPECT_NEAR(static_cast<double>(outside) / draws, 0.05, 0.006) << freedom;
  }
  statistics::RandomStream random(4, 1);
  EXPECT_EQ(statistics::few_blocks_scale(random, INFINITY), 1);
}

TEST(Percentiles, AreThoseOfTheSortedValues) {
  std::vector<double> values(1001);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = 1000 - static_cast<double>(k);
  const statistics::Estimate interval = statistics::percentile_interval(400, values);
  EXPECT_DOUBLE_EQ(interval.low, 25);
  EXPECT_DOUBLE_EQ(interval.high, 975);
  EXPECT_DOUBLE_EQ(interval.value, 400);
}

TEST(Percentiles, FailedResamplesCountUntilTheyAreTooMany) {
  std::vector<double> values(100, 1.0);
  values[0] = NAN;
  EXPECT_TRUE(std::isfinite(statistics::percentile_interval(1, values).high));
  for (std::size_t k = 0; k < 10; ++k) values[k] = NAN;
  EXPECT_FALSE(std::isfinite(statistics::percentile_interval(1, values).high));
}

TEST(Percentiles, RootMeanSquareOfNoiseAloneMayBeZero) {
  // The data's own rms is noise of 1; a resample lays as much on it again.
  statistics::RandomStream random(5, 1);
  std::vector<double> values;
  for (int k = 0; k < 2000; ++k) {
    double squares = 0;
    for (int i = 0; i < 20; ++i) {
      squares += std::pow((i % 2 == 0 ? 1.0 : -1.0) + random.normal(), 2) / 20;
    }
    values.push_back(std::sqrt(squares));
  }
  const statistics::Estimate interval = statistics::root_mean_square_interval(1, values);
  EXPECT_EQ(interval.low, 0);
  EXPECT_GE(interval.high, 1);
  EXPECT_LT(interval.high, 1.5);
}

TEST(Resamples, TooFewOrTooManyAreRefused) {
  EXPECT_TRUE(joint::resamples_are_allowed(0));
  EXPECT_FALSE(joint::resamples_are_allowed(1));
  EXPECT_FALSE(joint::resamples_are_allowed(99));
  EXPECT_TRUE(joint::resamples_are_allowed(100));
  EXPECT_FALSE(joint::resamples_are_allowed(1000001));
}

}  // namespace
}  // namespace tribolog::bootstrap::bootstrap_test
