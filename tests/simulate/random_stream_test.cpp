#include "statistics/random_stream.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog::random_stream_test {
namespace {

TEST(RandomStream, IsTheSameEverywhere) {
  // Fixed numbers: another library or machine must give the same.
  statistics::RandomStream a(42, 0);
  statistics::RandomStream b(42, 0);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(a.normal(), b.normal());
  EXPECT_NE(statistics::RandomStream(42, 0).uniform(), statistics::RandomStream(42, 1).uniform());
  EXPECT_NE(statistics::RandomStream(42, 0).uniform(), statistics::RandomStream(43, 0).uniform());
}

TEST(RandomStream, IsStandardNormal) {
  statistics::RandomStream r(7, 3);
  constexpr int n = 200'000;
  double sum = 0;
  double squares = 0;
  int beyond = 0;
  for (int i = 0; i < n; ++i) {
    const double x = r.normal();
    sum += x;
    squares += x * x;
    beyond += std::abs(x) > 1.959964 ? 1 : 0;
  }
  // Four standard errors of each statistic.
  EXPECT_NEAR(sum / n, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 4 * std::sqrt(2.0 / n));
  EXPECT_NEAR(static_cast<double>(beyond) / n, 0.05, 4 * std::sqrt(0.05 * 0.95 / n));
}

}  // namespace
}  // namespace tribolog::random_stream_test
