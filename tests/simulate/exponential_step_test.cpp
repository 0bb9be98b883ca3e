#include "friction/exponential_step.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog::exponential_step_test {
namespace {

TEST(ExpNonpositive, IsWithinTwoUnitsOfTheLibrary) {
  for (double x = 0; x > -690; x -= 0.0137) {
    EXPECT_NEAR(friction::exp_nonpositive(x) / std::exp(x), 1, 5e-16) << x;
  }
  EXPECT_EQ(friction::exp_nonpositive(0), 1);
  EXPECT_LT(friction::exp_nonpositive(-1e300), 1e-300);
}

TEST(ExpNearZero, IsWithinTwoUnitsOfTheLibrary) {
  for (double x = 0; x >= -friction::near_zero; x -= 1e-6) {
    EXPECT_NEAR(friction::exp_near_zero(x) / std::exp(x), 1, 5e-16) << x;
  }
}

/// J_k by Simpson's rule on a fine grid.
double moment(double length, int k) {
  constexpr int n = 20000;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double x = static_cast<double>(i) / n;
    const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * std::exp(-length * (1 - x)) * std::pow(x, k);
  }
  return sum / 3 / n;
}

TEST(StepMoments, SeriesAndExponentialGiveTheIntegrals) {
  for (const double length : {0.0, 1e-9, 1e-3, 0.009, 0.1, 0.2499, 0.25, 0.5, 1.0, 7.0, 40.0}) {
    const friction::StepMoments<double> m = length < friction::series_below
                                                ? friction::moments_by_series<10>(length)
                                                : friction::moments_by_exponential(length);
    EXPECT_NEAR(m.j0, moment(length, 0), 1e-12) << length;
    EXPECT_NEAR(m.j1, moment(length, 1), 1e-12) << length;
    EXPECT_NEAR(m.j2, moment(length, 2), 1e-12) << length;
    EXPECT_NEAR(m.decay, std::exp(-length), 1e-14) << length;
  }
}

TEST(StepMoments, ShortSeriesIsEnoughForShortSteps) {
  for (const double length : {0.0, 1e-4, 0.0099}) {
    const auto brief = friction::moments_by_series<5>(length);
    const auto full = friction::moments_by_series<10>(length);
    EXPECT_NEAR(brief.j0, full.j0, 1e-15);
    EXPECT_NEAR(brief.j2, full.j2, 1e-15);
  }
}

TEST(ExponentialStep, ConstantSpeedIsExactForAnyStep) {
  // dz/dt = w - w z/g has the solution g + (z0 - g) exp(-w t/g).
  const double g = 2e-3;
  for (const double w : {0.01, 1.0, 300.0}) {
    for (const double dt : {1e-6, 1e-3, 1.0, 100.0}) {
      const double z = friction::exponential_step<double>(w, w, w, g, g, g, dt, -1e-3);
      EXPECT_NEAR(z, g + (-1e-3 - g) * std::exp(-w * dt / g), 1e-17 + 1e-13 * g);
      EXPECT_NEAR(friction::exponential_step<double>(-w, -w, -w, g, g, g, dt, 1e-3), -z, 1e-17);
    }
  }
}

}  // namespace
}  // namespace tribolog::exponential_step_test
