#include "method/selection/cross_checks.h"

#include <gtest/gtest.h>

#include "wording/words.h"

namespace tribolog::cross_checks_test {
namespace {

using method::hysteresis::Estimator;
using method::selection::CrossCheck;
using method::selection::CrossChecksResult;

/// Masses by the model and by the loops, with half widths of 0.1 and 0.2 % of gravity.
struct Masses {
  method::hysteresis::SurrogateMassesResult masses;
  method::hysteresis::HysteresisResult loops;

  void add(Estimator estimator, double gravity_Nm, double half_width_Nm) {
    method::hysteresis::SurrogateMass mass;
    mass.estimator = estimator;
    mass.gravity_Nm = statistics::symmetric_estimate(gravity_Nm, half_width_Nm);
    masses.masses.push_back(mass);
  }
  explicit Masses(double midline_Nm) {
    masses.distance_m = 0.5;
    masses.gravity_m_s2 = 9.81;
    add(Estimator::AB, midline_Nm, 0.004);
    add(Estimator::midline, midline_Nm, 0.004);
    add(Estimator::sweep, 2.2, 0.001);
    add(Estimator::model, 2.0, 0.002);
  }
  [[nodiscard]] CrossChecksResult checked(Estimator recommended = Estimator::model) const {
    return method::selection::cross_check(masses, recommended, loops, 100);
  }
};

const CrossCheck& check_of(const CrossChecksResult& r, Estimator estimator) {
  for (const CrossCheck& check : r.checks) {
    if (check.estimator == estimator) return check;
  }
  throw std::logic_error("not compared");
}

TEST(CrossChecks, LoopsThatAgreeWithTheModelSayNothing) {
  const CrossChecksResult r = Masses(2.003).checked();
  EXPECT_EQ(r.checks.size(), 4U);
  EXPECT_TRUE(r.findings.empty());
  EXPECT_FALSE(r.doubtful);
  const CrossCheck& midline = check_of(r, Estimator::midline);
  EXPECT_FALSE(midline.disagrees);
  EXPECT_NEAR(midline.difference_percent, 0.15, 1e-9);
  EXPECT_NEAR(midline.difference_half_width_percent, 0.2238, 1e-3);
  EXPECT_NEAR(midline.mass_kg.value, 2.003 * 100 / 9.81 / 0.5, 1e-9);
}

TEST(CrossChecks, TheSweepIsReadFromTheModelsOwnSamples) {
  const CrossChecksResult r = Masses(2.003).checked();
  const CrossCheck& sweep = check_of(r, Estimator::sweep);
  EXPECT_TRUE(sweep.disagrees);
  EXPECT_FALSE(sweep.counts());
  EXPECT_TRUE(check_of(Masses(2.0).checked(Estimator::midline), Estimator::sweep).counts());
}

TEST(CrossChecks, LoopsThatDisagreeAreToldAndFromOnePercentDoubtful) {
  const CrossChecksResult little = Masses(2.01).checked();
  ASSERT_EQ(little.findings.size(), 2U);
  EXPECT_NE(wording::words(little.findings[1]).find("+0.50 %"), std::string::npos);
  EXPECT_FALSE(little.doubtful);
  EXPECT_TRUE(Masses(2.03).checked().doubtful);
  EXPECT_TRUE(Masses(1.97).checked().doubtful);
}

TEST(CrossChecks, PairsOfPointsOfALoopWithHarmonicsDoNotCount) {
  Masses of_no_sine(2.03);
  of_no_sine.loops.oscillations.resize(1);
  of_no_sine.loops.oscillations.front().third_harmonic = 0.01;
  const CrossChecksResult r = of_no_sine.checked();
  EXPECT_TRUE(check_of(r, Estimator::AB).is_biased);
  EXPECT_EQ(r.findings.size(), 1U);
}

TEST(CrossChecks, OfNoGravityThereAreNoShares) {
  Masses none(2);
  for (auto& mass : none.masses.masses) mass.gravity_Nm = statistics::symmetric_estimate(0, 0.1);
  EXPECT_TRUE(none.checked().checks.empty());
  EXPECT_TRUE(method::selection::cross_check(none.masses, {}, {}, 100).checks.empty());
}

}  // namespace
}  // namespace tribolog::cross_checks_test
