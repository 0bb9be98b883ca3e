#include "stages/gravity_at_positions.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tribolog {
namespace {

constexpr double turn = 2 * std::numbers::pi;

Estimate reading(double value, double half_width) {
  return symmetric_estimate(value, half_width, "cycles");
}

TEST(GravityAtPositions, PositionsCountOnceWhereTheySeeTheSameRipple) {
  EXPECT_EQ(distinct_positions({0, 0, 0}, 1), 1U);
  EXPECT_EQ(distinct_positions({0, turn / 8, turn / 4}, 1), 3U);
  // The same joint angles are a hundred times further apart at the motor.
  EXPECT_EQ(distinct_positions({0, 1e-3, 2e-3}, 1), 1U);
  EXPECT_EQ(distinct_positions({0, 1e-2, 2e-2}, 100), 3U);
  EXPECT_EQ(distinct_positions({}, 1), 0U);
}

TEST(GravityAtPositions, ScatterOfThreeMakesTheInterval) {
  const Estimate e = combined_over_recordings(
      {reading(1, 1e-6), reading(2, 1e-6), reading(3, 1e-6)}, {0, 1, 2}, 1, "cycles");
  EXPECT_DOUBLE_EQ(e.value, 2);
  // Standard error 1/sqrt(3), Student's t of two degrees of freedom 4.303.
  EXPECT_NEAR(e.half_width(), 4.303 / std::sqrt(3.0), 1e-3);
}

TEST(GravityAtPositions, OneStaysAndNoneIsAnError) {
  const Estimate one = reading(1, 0.1);
  EXPECT_EQ(combined_over_recordings({one}, {0}, 1, "cycles").half_width(), one.half_width());
  EXPECT_THROW(combined_over_recordings({}, {}, 1, "cycles"), std::invalid_argument);
}

TEST(GravityAtPositions, TwoThatAgreeKeepTheirOwnIntervals) {
  const Estimate e =
      combined_over_recordings({reading(1, 0.3), reading(1, 0.4)}, {0, 1}, 1, "cycles");
  EXPECT_NEAR(e.half_width(), 0.25, 1e-12);
}

TEST(GravityAtPositions, RippleOverAnEvenTurnIsNoError) {
  std::vector<Estimate> readings;
  std::vector<double> centres;
  const double small[] = {1, -2, 0.5, 1.5, -1, 0, 2, -2};
  for (int k = 0; k < 8; ++k) {
    const double motor = 0.3 + k * turn / 8;
    centres.push_back(motor / 100);
    readings.push_back(reading(
        3.9 + 0.02 * std::sin(motor) + 0.02 * std::cos(6 * motor + 1) + 1e-4 * small[k], 1e-4));
  }
  const Estimate e = combined_over_recordings(readings, centres, 100, "cycles");
  EXPECT_NEAR(e.value, 3.9, 1e-4);
  EXPECT_LT(e.half_width(), 1e-3);
  // The same readings from one half of the turn say nothing of the other.
  for (double& q : centres) q /= 2;
  EXPECT_GT(combined_over_recordings(readings, centres, 100, "cycles").half_width(), 5e-3);
}

}  // namespace
}  // namespace tribolog
