#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"
#include "study/study.h"

namespace tribolog::statistics_test {
namespace {

statistics::Estimate around(double value, double half_width) {
  return statistics::symmetric_estimate(value, half_width);
}

TEST(WilsonShare, AgreesWithPublishedValues) {
  // Newcombe (1998), Statistics in Medicine 17, table I, method 3: 81 of 263, 15 of 148, 0 of 20,
  // 1 of 29.
  struct Row {
    std::size_t hits, trials;
    double low, high;
  };
  for (const Row& row : {Row{81, 263, 0.2553, 0.3662}, Row{15, 148, 0.0624, 0.1605},
                         Row{0, 20, 0.0, 0.1611}, Row{1, 29, 0.0061, 0.1718}}) {
    const study::Share share = study::wilson_share(row.hits, row.trials);
    EXPECT_NEAR(share.low, row.low, 5e-5) << row.hits;
    EXPECT_NEAR(share.high, row.high, 5e-5) << row.hits;
  }
}

TEST(WilsonShare, MirrorsAndStaysWithinZeroToOne) {
  for (const std::size_t hits : {0U, 1U, 7U, 19U, 20U}) {
    const study::Share share = study::wilson_share(hits, 20);
    const study::Share mirror = study::wilson_share(20 - hits, 20);
    EXPECT_NEAR(share.low, 1 - mirror.high, 1e-12);
    EXPECT_GE(share.low, 0);
    EXPECT_LE(share.high, 1);
    EXPECT_LE(share.low, share.value);
    EXPECT_GE(share.high, share.value);
  }
}

TEST(WilsonShare, RefusesTheImpossible) {
  EXPECT_THROW(study::wilson_share(0, 0), std::invalid_argument);
  EXPECT_THROW(study::wilson_share(3, 2), std::invalid_argument);
}

TEST(ErrorStatistics, HandWorkedSample) {
  // Errors of -1, 0, 1, 4 about a truth of 10: mean 1, squares of the rest 4 + 1 + 0 + 9 = 14.
  const std::vector<statistics::Estimate> estimates{around(9, 0.5), around(10, 0.5),
                                                    around(11, 1.5), around(14, 1.5)};
  const study::ErrorStatistics e = study::error_statistics(estimates, 10, 5);
  EXPECT_EQ(e.runs, 5U);
  EXPECT_EQ(e.found, 4U);
  EXPECT_DOUBLE_EQ(e.bias, 1);
  EXPECT_DOUBLE_EQ(e.scatter, std::sqrt(14.0 / 3));
  EXPECT_DOUBLE_EQ(e.bias_standard_error, std::sqrt(14.0 / 3) / 2);
  EXPECT_DOUBLE_EQ(e.error_95, 4);
  EXPECT_DOUBLE_EQ(e.half_width, 1);
  EXPECT_DOUBLE_EQ(e.coverage.value, 0.5);
}

TEST(ErrorStatistics, WithoutEstimatesThereIsNothing) {
  const study::ErrorStatistics e = study::error_statistics({}, 10, 5);
  EXPECT_EQ(e.found, 0U);
  EXPECT_TRUE(std::isnan(e.bias));
  EXPECT_FALSE(e.is_biased(0));
  EXPECT_FALSE(e.intervals_too_narrow());
}

TEST(ErrorStatistics, OneEstimateHasNoScatter) {
  const study::ErrorStatistics e = study::error_statistics({around(11, 2)}, 10, 1);
  EXPECT_DOUBLE_EQ(e.bias, 1);
  EXPECT_TRUE(std::isnan(e.scatter));
  EXPECT_FALSE(e.is_biased(0));
}

TEST(ErrorStatistics, NinetyFiveOfAHundredErrorsAreNoLarger) {
  std::vector<statistics::Estimate> estimates;
  for (int i = 1; i <= 100; ++i) estimates.push_back(around(i % 2 == 0 ? i : -i, 0));
  EXPECT_DOUBLE_EQ(study::error_statistics(estimates, 0, 100).error_95, 95);
}

/// Normal errors with a bias; intervals of a width of so many standard deviations.
study::ErrorStatistics normal_sample(double bias, double widths) {
  constexpr std::size_t runs = 1000;
  statistics::RandomStream random(42, 0);
  std::vector<statistics::Estimate> estimates;
  for (std::size_t i = 0; i < runs; ++i) {
    estimates.push_back(around(5 + bias + random.normal(), widths));
  }
  return study::error_statistics(estimates, 5, runs);
}

TEST(ErrorStatistics, FindsABiasOnlyWhereItIsSureAndMatters) {
  EXPECT_FALSE(normal_sample(0, 1.96).is_biased(0));
  EXPECT_TRUE(normal_sample(0.5, 1.96).is_biased(0.1));
  EXPECT_FALSE(normal_sample(0.5, 1.96).is_biased(1));
}

TEST(ErrorStatistics, KnowsHonestIntervalsFromNarrowAndWideOnes) {
  const study::ErrorStatistics honest = normal_sample(0, 1.96);
  EXPECT_NEAR(honest.coverage.value, 0.95, 0.02);
  EXPECT_FALSE(honest.intervals_too_narrow());
  EXPECT_FALSE(honest.intervals_too_wide());
  EXPECT_TRUE(normal_sample(0, 1).intervals_too_narrow());
  EXPECT_TRUE(normal_sample(0, 6).intervals_too_wide());
}

}  // namespace
}  // namespace tribolog::statistics_test
