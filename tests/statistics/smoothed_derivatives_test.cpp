// Smoothed derivatives: exact on polynomials, and a linear law between two signals keeps its
// coefficients, however much of the signals the smoothing takes away.

#include "statistics/smoothed_derivatives.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace tribolog::smoothed_derivatives_test {
namespace {

constexpr double dt_s = 1e-2;

Eigen::VectorXd sampled(std::size_t half, double (*signal)(double)) {
  const auto n = static_cast<int>(half);
  Eigen::VectorXd out(2 * n + 1);
  for (int i = -n; i <= n; ++i) out(i + n) = signal(dt_s * i);
  return out;
}

TEST(SmoothedDerivatives, AreExactWhereADerivativeIsConstant) {
  for (const std::size_t half : {4U, 6U, 13U, 40U}) {
    const Eigen::MatrixXd w = statistics::SmoothedDerivatives(half, dt_s).weights();
    const Eigen::VectorXd line = w * sampled(half, [](double t) { return 3 + 7 * t; });
    EXPECT_NEAR(line(0), 3, 1e-12);
    EXPECT_NEAR(line(1), 7, 1e-10);
    EXPECT_NEAR(line(2), 0, 1e-8);
    EXPECT_NEAR(line(3), 0, 1e-6);
    const Eigen::VectorXd quartic = w * sampled(half, [](double t) { return t * t * t * t / 24; });
    EXPECT_NEAR(quartic(4), 1, 1e-6);
    EXPECT_NEAR(quartic(3), 0, 1e-8);
  }
}

TEST(SmoothedDerivatives, KeepACoefficientThatSmoothingWouldBend) {
  // y = 2 x'' where x swings once in a window: little of x'' is left, and as little of y.
  constexpr std::size_t half = 20;
  const Eigen::MatrixXd w = statistics::SmoothedDerivatives(half, dt_s).weights();
  const Eigen::VectorXd x = sampled(half, [](double t) { return std::cos(20 * t); });
  const Eigen::VectorXd y = sampled(half, [](double t) { return -2 * 400 * std::cos(20 * t); });
  const double second = w.row(2) * x;
  EXPECT_LT(std::abs(second), 0.9 * 400);
  EXPECT_NEAR((w.row(0) * y).value() / second, 2, 0.01);
}

}  // namespace
}  // namespace tribolog::smoothed_derivatives_test
