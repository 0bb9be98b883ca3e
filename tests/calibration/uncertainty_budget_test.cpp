// Combining the parts of an uncertainty budget after JCGM 100.

#include "calibration/uncertainty_budget.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "statistics/distributions.h"
#include "statistics/random_stream.h"

namespace tribolog::calibration::uncertainty_budget_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

BudgetPart type_a(double standard_uncertainty, double freedom) {
  return {Influence::recordings, false, std::nullopt, 1, standard_uncertainty, freedom, 0};
}
BudgetPart type_b(double standard_uncertainty) {
  return {Influence::torque_constant, true, 2.0, 1, standard_uncertainty, infinite, 0};
}

TEST(UncertaintyBudget, WithoutTypeBIsTheIntervalAsItWas) {
  const statistics::Estimate e{10, 9, 12, {}};
  const UncertaintyBudget b = combined(e, {type_a(1.5 / coverage_factor(4), 4)}, {});
  EXPECT_EQ(b.expanded.low, 9);
  EXPECT_EQ(b.expanded.high, 12);
  EXPECT_DOUBLE_EQ(b.freedom, 4);
  EXPECT_DOUBLE_EQ(b.parts.front().share, 1);
}

TEST(UncertaintyBudget, OfWellKnownPartsIsTheRootOfTheSquares) {
  const double k = coverage_factor(infinite);
  const statistics::Estimate e{10, 10 - 3 * k, 10 + 3 * k, {}};
  const UncertaintyBudget b = combined(e, {type_a(3, infinite), type_b(4)}, {});
  EXPECT_DOUBLE_EQ(b.standard_uncertainty, 5);
  EXPECT_NEAR(b.expanded.half_width(), 5 * k, 1e-12);
  EXPECT_TRUE(std::isinf(b.freedom));
  // The larger first.
  EXPECT_EQ(b.parts.front().influence, Influence::torque_constant);
  EXPECT_DOUBLE_EQ(b.parts.front().share, 0.64);
}

/// JCGM 100, G.4.2: u1 = 0.25 with 9 degrees of freedom beside 0.57 and 0.82 percent; here the
/// others are well known, and the effective number is u^4 / (u1^4 / 9).
TEST(UncertaintyBudget, HasTheDegreesOfFreedomOfWelchAndSatterthwaite) {
  const double u2 = 0.25 * 0.25 + 0.57 * 0.57 + 0.82 * 0.82;
  const double half_width = 0.25 * coverage_factor(9);
  const UncertaintyBudget b = combined(statistics::symmetric_estimate(1, half_width),
                                       {type_a(0.25, 9), type_b(0.57), type_b(0.82)}, {});
  EXPECT_NEAR(b.freedom, u2 * u2 / (std::pow(0.25, 4) / 9), 1e-9 * b.freedom);
  EXPECT_NEAR(b.coverage_factor, statistics::student_t_975(b.freedom), 1e-12);
}

TEST(UncertaintyBudget, WidensEachSideOfAnIntervalByItself) {
  const double k = coverage_factor(infinite);
  const statistics::Estimate e{0, -1 * k, 3 * k, {}};
  const UncertaintyBudget b = combined(e, {type_a(2, infinite), type_b(1)}, {});
  EXPECT_NEAR(b.expanded.low, -std::sqrt(2.0) * k, 1e-12);
  EXPECT_NEAR(b.expanded.high, std::sqrt(10.0) * k, 1e-12);
}

/// The gear ratio takes part in a torque at the joint but not in that at the motor.
TEST(UncertaintyBudget, HangsOnTheGearByTheSideOfTheQuantity) {
  const double k = coverage_factor(infinite);
  const statistics::Estimate e = statistics::symmetric_estimate(50, 0);
  const BudgetPart gear{Influence::gear_ratio, true, 1.0, 0, 0, infinite, 0};
  const UncertaintyBudget b = combined(e, {type_a(0, infinite), gear}, {});
  EXPECT_EQ(expanded_at(b, e, 0).half_width(), 0);
  EXPECT_NEAR(expanded_at(b, e, 1).half_width(), 0.5, 1e-12);
  EXPECT_NEAR(expanded_at(b, e, 2).half_width(), 1, 1e-12);
  EXPECT_NEAR(combined(e, {type_b(0.5 / k)}, {}).expanded.half_width(), 0.5, 1e-12);
}

/// The mean of five readings with an error that all share: 95 of 100 expanded intervals hold it.
TEST(UncertaintyBudget, HoldsTheTruthAsOftenAsItSays) {
  constexpr std::size_t trials = 4000;
  constexpr std::size_t readings = 5;
  statistics::RandomStream random(3, 1);
  std::size_t inside = 0;
  for (std::size_t k = 0; k < trials; ++k) {
    const double shared = 0.4 * random.normal();
    double mean = 0;
    double squares = 0;
    for (std::size_t i = 0; i < readings; ++i) {
      const double x = shared + random.normal();
      mean += x / readings;
      squares += x * x;
    }
    const double variance = (squares - readings * mean * mean) / (readings - 1) / readings;
    const double u = std::sqrt(variance);
    const auto e = statistics::symmetric_estimate(mean, u * coverage_factor(readings - 1));
    const UncertaintyBudget b = combined(e, {type_a(u, readings - 1), type_b(0.4)}, {});
    inside += b.expanded.low <= 0 && 0 <= b.expanded.high ? 1 : 0;
  }
  EXPECT_GT(inside, 0.935 * trials);
  EXPECT_LT(inside, 0.975 * trials);
}

}  // namespace
}  // namespace tribolog::calibration::uncertainty_budget_test
