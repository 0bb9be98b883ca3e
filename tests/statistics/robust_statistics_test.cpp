#include <cmath>

#include <gtest/gtest.h>

#include "statistics/order_statistics.h"
#include "statistics/random_stream.h"

namespace tribolog::archive::robust_statistics_test {
namespace {

TEST(RobustStatistics, MedianOfFewAndMany) {
  EXPECT_EQ(statistics::median_of({3}), 3);
  EXPECT_EQ(statistics::median_of({4, 1}), 2.5);
  EXPECT_EQ(statistics::median_of({9, 1, 2}), 2);
  EXPECT_EQ(statistics::median_of({9, 1, 2, 4}), 3);
  EXPECT_ANY_THROW((void)statistics::median_of({}));
}

TEST(RobustStatistics, ScatterOfNormalValuesIsTheirStandardDeviation) {
  // Its standard error over the draws is below 1 %; the factors for few values are tabulated.
  constexpr double tolerance = 0.03;
  for (const std::size_t n : {5U, 6U, 7U, 8U, 9U, 10U, 40U, 41U, 400U, 1000U}) {
    statistics::RandomStream random(3, n);
    const int draws = n < 100 ? 5000 : 200;
    double sum = 0;
    double squares = 0;
    for (int k = 0; k < draws; ++k) {
      std::vector<double> values;
      for (std::size_t i = 0; i < n; ++i) values.push_back(7 + 2 * random.normal());
      const double scatter = statistics::pairwise_scatter(values) / 2;
      sum += scatter;
      squares += scatter * scatter;
    }
    EXPECT_NEAR(sum / draws, 1, tolerance) << n;
    // It is as sure as a standard deviation of so many degrees of freedom.
    if (n > 100 || n < 40) continue;
    const double relative = std::sqrt(squares / draws - std::pow(sum / draws, 2));
    EXPECT_NEAR(relative / std::sqrt(1 / (2 * statistics::scatter_freedom(n))), 1, 0.1) << n;
  }
}

TEST(RobustStatistics, OutliersDoNotMoveTheScatter) {
  statistics::RandomStream random(4, 0);
  std::vector<double> values;
  for (int i = 0; i < 100; ++i) values.push_back(random.normal() + (i < 20 ? 1e6 : 0));
  EXPECT_LT(statistics::pairwise_scatter(values), 1.6);
  EXPECT_GT(statistics::pairwise_scatter(values), 0.8);
}

TEST(RobustStatistics, DeviatesAreThoseOfTheTables) {
  EXPECT_NEAR(statistics::deviate_of(0.05), 1.959963984540054, 1e-9);
  EXPECT_NEAR(statistics::deviate_of(0.001), 3.290526731491926, 1e-9);
}

TEST(EvenInterval, IsThatOfTheClockWhateverIsRoundedOrMissing) {
  for (const double interval : {1 / 300.0, 1 / 400.0, 1 / 600.0, 1 / 700.0, 0.01}) {
    std::vector<double> rounded;
    std::vector<double> with_gaps;
    for (int i = 0; i < 3000; ++i) {
      rounded.push_back(std::round(1e3 * interval * i) / 1e3);
      if (i % 20 != 7 && (i < 1000 || i > 1500)) with_gaps.push_back(interval * i);
    }
    EXPECT_NEAR(statistics::even_interval(rounded) / interval, 1, 2e-4) << interval;
    EXPECT_NEAR(statistics::even_interval(with_gaps) / interval, 1, 1e-9) << interval;
  }
  EXPECT_TRUE(std::isnan(statistics::even_interval({1})));
}

}  // namespace
}  // namespace tribolog::archive::robust_statistics_test
