#include "figures/outliers.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "figures/cross_check_figures.h"
#include "figures/hand_made_calibration.h"

namespace tribolog::figures::outliers_test {
namespace {

using method::hysteresis::Estimator;

TEST(ReachOfTheMany, EndsBeforeAFarOutlier) {
  EXPECT_EQ(reach_of_the_many({1, 2, 3, 2, 1, 40}), 3);
  EXPECT_EQ(reach_of_the_many({1, 2, 3, 2, 1, 40, 60}), 3);
}

TEST(ReachOfTheMany, IsNoneWhereNothingIsFarOrHalfIs) {
  EXPECT_EQ(reach_of_the_many({1, 2, 3, 2, 1, 11}), 0);
  EXPECT_EQ(reach_of_the_many({1, 1, 1, 40, 40, 40}), 0);
  EXPECT_EQ(reach_of_the_many({1, 40}), 0);
  EXPECT_EQ(reach_of_the_many({}), 0);
  // All the same: any other is infinitely far in proportion, and says nothing.
  EXPECT_EQ(reach_of_the_many({0, 0, 0, 0, 1e-9}), 0);
}

TEST(ReachOfTheMany, PassesOverWhatIsNotFinite) {
  EXPECT_EQ(reach_of_the_many({1, 2, std::nan(""), 3, 2, 1, 40}), 3);
  EXPECT_EQ(reach_of_the_many({std::numeric_limits<double>::infinity(), 1, 1}), 0);
}

method::selection::CrossCheck check_of(Estimator estimator, double mass_kg, double half_kg) {
  method::selection::CrossCheck check;
  check.estimator = estimator;
  check.mass_kg.value = mass_kg;
  check.mass_kg.low = mass_kg - half_kg;
  check.mass_kg.high = mass_kg + half_kg;
  return check;
}

class MassComparison : public ::testing::Test {
 protected:
  MassComparison() {
    auto& checks = calibration_.cross_checks.checks;
    checks = {check_of(Estimator::midline, 79.0, 0.1), check_of(Estimator::AB, 79.05, 0.1),
              check_of(Estimator::CD, 78.95, 0.1), check_of(Estimator::sweep, 79.1, 0.1),
              check_of(Estimator::fit, 79.2, 3.0)};
    checks.front().is_recommended = true;
  }
  calibration::Calibration calibration_;
};

TEST_F(MassComparison, NamesTheEstimatorsOnTheAxisTheFirstOnTop) {
  const auto figure = mass_comparison_figure(calibration_);
  ASSERT_TRUE(figure);
  EXPECT_TRUE(figure->is_primary);
  const render::figure::Axis& axis = figure->figure.panels.front().y;
  ASSERT_EQ(axis.names.size(), 5U);
  EXPECT_EQ(axis.names.front().text, "mid-line");
  EXPECT_EQ(axis.names.front().at, 5.0);
  EXPECT_EQ(axis.names.back().text, "LuGre fit");
  EXPECT_EQ(axis.names.back().at, 1.0);
}

TEST_F(MassComparison, AWideIntervalEndsInArrowsAndItsValueIsWritten) {
  const auto figure = mass_comparison_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels.front();
  ASSERT_EQ(panel.point_labels.size(), 1U);
  EXPECT_EQ(panel.point_labels.front().text, "79.2 ± 3.0 kg");
  EXPECT_EQ(panel.point_labels.front().y, 1.0);
  ASSERT_TRUE(panel.x.minimum && panel.x.maximum);
  EXPECT_LT(*panel.x.maximum - *panel.x.minimum, 1.0);  // of 6 kg
  std::size_t arrows = 0;
  for (const render::figure::Series& one : panel.series) {
    arrows += one.direction_arrows_at.empty() ? 0 : 1;
    for (const double x : one.x) {
      EXPECT_GE(x, *panel.x.minimum);
      EXPECT_LE(x, *panel.x.maximum);
    }
  }
  EXPECT_EQ(arrows, 2U);  // both ends
}

TEST_F(MassComparison, NothingIsCutOffWhereAllAreAlike) {
  calibration_.cross_checks.checks.pop_back();
  const auto figure = mass_comparison_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels.front();
  EXPECT_TRUE(panel.point_labels.empty());
  for (const render::figure::Series& one : panel.series) {
    EXPECT_TRUE(one.direction_arrows_at.empty());
  }
}

TEST_F(MassComparison, AMassFarAwayHasAnArrowOnItsSideAlone) {
  calibration_.cross_checks.checks.back() = check_of(Estimator::fit, 60.0, 0.5);
  const auto figure = mass_comparison_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels.front();
  ASSERT_EQ(panel.point_labels.size(), 1U);
  EXPECT_EQ(panel.point_labels.front().text, "60.00 ± 0.50 kg");
  for (const render::figure::Series& one : panel.series) {
    if (!one.direction_arrows_at.empty()) {
      EXPECT_LT(one.x.back(), one.x.front());
    }
    if (one.style == render::figure::LineStyle::none) {
      EXPECT_EQ(one.x.size(), 4U);
    }
  }
}

}  // namespace
}  // namespace tribolog::figures::outliers_test
