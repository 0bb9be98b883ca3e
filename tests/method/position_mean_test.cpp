// Gravity over several positions: ripple averages out where it can, and counts as error where it
// cannot.

#include "method/hysteresis/position_mean.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace tribolog::position_mean_test {
namespace {

constexpr double turn = 2 * std::numbers::pi;

statistics::Estimate reading(double value, double half_width = 1e-6) {
  return statistics::symmetric_estimate(value, half_width);
}

method::gravity::Ripple two_lines() {
  method::gravity::Ripple ripple;
  ripple.lines = {{1, 0.02, 0.3}, {6, 0.015, 2.0}};
  return ripple;
}

std::vector<double> evenly_over_a_turn(int positions) {
  std::vector<double> angle;
  for (int k = 0; k < positions; ++k) angle.push_back(-38.8 + k * turn / positions);
  return angle;
}

constexpr Code scatter{"interval.scatter_of_cycles"};

TEST(PositionMean, PositionsCountOnceWhereTheySeeTheSameRipple) {
  EXPECT_EQ(method::hysteresis::distinct_positions({0, 0, 0}, {}), 1U);
  EXPECT_EQ(method::hysteresis::distinct_positions({0, turn / 8, turn / 4}, {}), 3U);
  EXPECT_EQ(method::hysteresis::distinct_positions({0, 0.1, 0.2}, {}), 1U);
  EXPECT_EQ(method::hysteresis::distinct_positions({}, {}), 0U);
  // Ripple of a hundred periods a turn changes within a tenth of a radian.
  EXPECT_EQ(method::hysteresis::distinct_positions({0, 0.1, 0.2}, {{{100, 0.02, 0}}, 0}), 3U);
}

TEST(PositionMean, ScatterOfThreeMakesTheInterval) {
  const method::hysteresis::PositionMean mean = method::hysteresis::mean_over_positions(
      {reading(1), reading(2), reading(3)}, {0, 1, 2}, {}, scatter);
  EXPECT_DOUBLE_EQ(mean.gravity_Nm.value, 2);
  EXPECT_EQ(mean.freedom, 2);
  // Standard error 1/sqrt(3), Student's t of two degrees of freedom 4.303.
  EXPECT_NEAR(mean.gravity_Nm.half_width(), 4.303 / std::sqrt(3.0), 1e-3);
  ASSERT_EQ(mean.residuals_Nm.size(), 3U);
  EXPECT_DOUBLE_EQ(mean.residuals_Nm[0], -1);
}

TEST(PositionMean, RepeatsOfAPositionTellNothingNewOfTheRipple) {
  const method::hysteresis::PositionMean once = method::hysteresis::mean_over_positions(
      {reading(1), reading(2), reading(3)}, {0, 1, 2}, {}, scatter);
  const method::hysteresis::PositionMean thrice = method::hysteresis::mean_over_positions(
      {reading(1), reading(1), reading(1), reading(2), reading(2), reading(2), reading(3),
       reading(3), reading(3)},
      {0, 1e-3, 2e-3, 1, 1, 1, 2, 2, 2}, {}, scatter);
  EXPECT_EQ(thrice.freedom, once.freedom);
  EXPECT_NEAR(thrice.gravity_Nm.half_width(), once.gravity_Nm.half_width(), 1e-9);
}

TEST(PositionMean, FewerThanThreeDistinctPositionsSayNothingOfTheRipple) {
  const statistics::Estimate one = reading(1, 0.1);
  EXPECT_EQ(
      method::hysteresis::mean_over_positions({one}, {0}, {}, scatter).gravity_Nm.half_width(),
      one.half_width());
  EXPECT_THROW(method::hysteresis::mean_over_positions({}, {}, {}, scatter), std::invalid_argument);
  // Two that agree keep their own intervals.
  const method::hysteresis::PositionMean two = method::hysteresis::mean_over_positions(
      {reading(1, 0.3), reading(1, 0.4)}, {0, 1}, {}, scatter);
  EXPECT_NEAR(two.gravity_Nm.half_width(), 0.25, 1e-12);
  EXPECT_EQ(two.freedom, 0);
  const method::hysteresis::PositionMean together = method::hysteresis::mean_over_positions(
      {reading(1), reading(1), reading(1)}, {0, 0.1, 0.2}, {}, scatter);
  EXPECT_EQ(together.freedom, 0);
  EXPECT_TRUE(together.residuals_Nm.empty());
}

TEST(PositionMean, EightPositionsOverATurnLeaveNothingOfTheRipple) {
  const method::gravity::Ripple ripple = two_lines();
  const std::vector<double> angle = evenly_over_a_turn(8);
  std::vector<statistics::Estimate> gravity;
  for (const double a : angle) gravity.push_back(reading(3.88 + ripple.torque_Nm(a)));
  const method::hysteresis::PositionMean mean =
      method::hysteresis::mean_over_positions(gravity, angle, ripple, scatter);
  EXPECT_NEAR(mean.gravity_Nm.value, 3.88, 1e-12);
  EXPECT_LT(mean.gravity_Nm.half_width(), 1e-12);
  EXPECT_EQ(mean.freedom, 3);
}

TEST(PositionMean, RippleOfUnknownPeriodsOverAnEvenTurnIsNoError) {
  const double small[] = {1, -2, 0.5, 1.5, -1, 0, 2, -2};
  const method::gravity::Ripple ripple = two_lines();
  std::vector<double> angle = evenly_over_a_turn(8);
  std::vector<statistics::Estimate> gravity;
  for (std::size_t k = 0; k < 8; ++k) {
    gravity.push_back(reading(3.88 + ripple.torque_Nm(angle[k]) + 1e-4 * small[k]));
  }
  const method::hysteresis::PositionMean mean =
      method::hysteresis::mean_over_positions(gravity, angle, {}, scatter);
  EXPECT_NEAR(mean.gravity_Nm.value, 3.88, 1e-4);
  EXPECT_LT(mean.gravity_Nm.half_width(), 1e-3);
  // The same readings from one half of the turn say nothing of the other.
  for (double& a : angle) a /= 2;
  EXPECT_GT(
      method::hysteresis::mean_over_positions(gravity, angle, {}, scatter).gravity_Nm.half_width(),
      5e-3);
}

TEST(PositionMean, KeepsALineThatRepeatsFromPositionToPosition) {
  const std::vector<double> angle = evenly_over_a_turn(8);
  EXPECT_NEAR(method::hysteresis::share_left_in_mean({8, 1, 0}, angle), 1, 1e-12);
  EXPECT_NEAR(method::hysteresis::share_left_in_mean({6, 1, 0}, angle), 0, 1e-12);
}

}  // namespace
}  // namespace tribolog::position_mean_test
