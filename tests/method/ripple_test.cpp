// Ripple with known periods comes back.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "method/gravity/ripple_spectrum.h"
#include "statistics/random_stream.h"

namespace tribolog::ripple_test {
namespace {

using std::numbers::pi;

method::gravity::Ripple two_lines() {
  method::gravity::Ripple ripple;
  ripple.lines = {{1, 0.02, 0.3}, {6, 0.015, 2.0}};
  return ripple;
}

TEST(RippleSpectrum, FindsPeriodsAmplitudesAndPhasesInNoise) {
  const method::gravity::Ripple truth = two_lines();
  statistics::RandomStream random(1, 1);
  std::vector<double> angle, residual;
  for (int i = 0; i < 60000; ++i) {
    angle.push_back(-100 + 0.004 * i);  // 38 turns
    residual.push_back(truth.torque_Nm(angle.back()) + 0.02 * random.normal());
  }
  const double sd = std::sqrt((0.02 * 0.02 + 0.015 * 0.015) / 2);
  const method::gravity::Ripple found =
      method::gravity::find_ripple(angle, residual, sd, 0.02 * 0.02);
  ASSERT_EQ(found.lines.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(found.lines[k].periods_per_turn, truth.lines[k].periods_per_turn, 1e-3);
    // Ten standard errors of an amplitude fitted to 60,000 samples.
    EXPECT_NEAR(found.lines[k].amplitude_Nm, truth.lines[k].amplitude_Nm, 1.2e-3);
  }
  EXPECT_EQ(found.rest_Nm, 0);
  for (double a = -100; a < 100; a += 0.37) {
    EXPECT_NEAR(found.torque_Nm(a), truth.torque_Nm(a), 1.5e-3) << a;
  }
}

TEST(RippleSpectrum, FindsNothingInWhiteNoise) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    statistics::RandomStream random(seed, 2);
    std::vector<double> angle, residual;
    for (int i = 0; i < 20000; ++i) {
      angle.push_back(0.01 * i);
      residual.push_back(0.02 * random.normal());
    }
    EXPECT_TRUE(method::gravity::find_ripple(angle, residual, 0.005, 0.02 * 0.02).lines.empty())
        << seed;
  }
}

TEST(RippleSpectrum, HalfWidthOfOneLineIsNearlyItsAmplitude) {
  // |cos u| < cos(0.025 pi) for 95 % of all u.
  EXPECT_NEAR(method::gravity::random_phase_half_width({2.0}, 0), 2 * std::cos(0.025 * pi), 0.01);
  EXPECT_NEAR(method::gravity::random_phase_half_width({}, 1.0), 1.96, 1e-3);
}

}  // namespace
}  // namespace tribolog::ripple_test
