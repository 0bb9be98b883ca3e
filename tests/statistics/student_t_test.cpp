#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "statistics/distributions.h"

namespace tribolog::student_t_test {
namespace {

/// Integral of cos^(f-1) from 0 to `end` (below pi/2), to about ten digits: with t = sqrt(f) tan x
/// the density of Student's t is cos^(f-1)(x), but for its size.
double below(double end, double f) {
  constexpr int steps = 20000;  // Simpson's rule
  double sum = 1 + std::pow(std::cos(end), f - 1);
  for (int k = 1; k < steps; ++k) {
    sum += (k % 2 == 1 ? 4 : 2) * std::pow(std::cos(end * k / steps), f - 1);
  }
  return sum * end / steps / 3;
}

/// Probability that Student's t lies within -t .. t.
double within(double t, double f) {
  const double all =
      std::sqrt(std::acos(-1.0)) / 2 * std::exp(std::lgamma(f / 2) - std::lgamma((f + 1) / 2));
  return below(std::atan(t / std::sqrt(f)), f) / all;
}

TEST(StudentT, AgreesWithPublishedTables) {
  const std::pair<double, double> table[] = {
      {1, 12.7062}, {2, 4.3027},  {3, 3.1824},  {4, 2.7764},   {5, 2.5706},   {8, 2.3060},
      {10, 2.2281}, {30, 2.0423}, {60, 2.0003}, {120, 1.9799}, {1e7, 1.95996}};
  for (const auto& [freedom, t] : table)
    EXPECT_NEAR(statistics::student_t_975(freedom), t, 6e-5) << freedom;
}

TEST(StudentT, HoldsNineteenOfTwentyWhateverTheFreedom) {
  for (const double f : {1.0, 1.001, 1.05, 1.1, 1.5, 1.999, 2.001, 2.5, 4.7, 17.3, 119.5, 3000.0}) {
    EXPECT_NEAR(within(statistics::student_t_975(f), f), 0.95, 1e-9) << f;
  }
  EXPECT_NEAR(statistics::student_t_975(1.05), 11.36190767, 1e-7);
}

TEST(StudentT, FallsFromOneDegreeOfFreedomToTheNormal) {
  double above = std::numeric_limits<double>::infinity();
  for (double f = 1; f < 1e6; f *= 1.003) {
    const double t = statistics::student_t_975(f);
    ASSERT_LT(t, above) << f;
    ASSERT_GT(t, statistics::normal_975) << f;
    above = t;
  }
  for (const double f : {1e12, 1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_NEAR(statistics::student_t_975(f), statistics::normal_975, 1e-11) << f;
  }
}

TEST(StudentT, SaysNothingWithoutFreedom) {
  for (const double f : {0.0, 0.999, -3.0, std::nan("")}) {
    EXPECT_TRUE(std::isinf(statistics::student_t_975(f))) << f;
  }
}

}  // namespace
}  // namespace tribolog::student_t_test
