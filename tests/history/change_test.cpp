#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "history/comparison.h"
#include "statistics/random_stream.h"

namespace tribolog::history::change_test {
namespace {

TEST(Change, AddsSidesThatMoveItTheSameWay) {
  const statistics::Estimate first{10, 10 - 3, 10 + 0.4, {}};
  const statistics::Estimate second{12, 12 - 0.3, 12 + 4, {}};
  const Change change = change_between(first, second, false);
  EXPECT_DOUBLE_EQ(change.absolute.value, 2);
  EXPECT_DOUBLE_EQ(change.absolute.low, 2 - 0.5) << "0.3 and 0.4";
  EXPECT_DOUBLE_EQ(change.absolute.high, 2 + 5) << "3 and 4";
  ASSERT_TRUE(change.percent);
  EXPECT_DOUBLE_EQ(change.percent->value, 20);
  EXPECT_DOUBLE_EQ(change.percent->high, 70);
}

TEST(Change, BackwardsIsItsMirrorImage) {
  const statistics::Estimate a{10, 9, 10.5, {}};
  const statistics::Estimate b{11, 10.8, 13, {}};
  const Change there = change_between(a, b, false);
  const Change back = change_between(b, a, false);
  EXPECT_DOUBLE_EQ(there.absolute.low, -back.absolute.high);
  EXPECT_DOUBLE_EQ(there.absolute.high, -back.absolute.low);
  EXPECT_DOUBLE_EQ(there.chance, back.chance);
}

TEST(Change, HasTheIntervalThatItsChanceSpeaksOf) {
  const Change at_the_edge = change_between({0, -0.6, 0.6, {}}, {1, 1 - 0.8, 1 + 0.8, {}}, false);
  EXPECT_NEAR(at_the_edge.absolute.low, 0, 1e-12);
  EXPECT_NEAR(at_the_edge.chance, 0.05, 1e-9);
}

TEST(Change, OfEqualEstimatesIsNone) {
  const statistics::Estimate e{0.45, 0.44, 0.46, {}};
  EXPECT_EQ(change_between(e, e, false).chance, 1);
  EXPECT_EQ(change_between({1, 1, 1, {}}, {1, 1, 1, {}}, false).chance, 1);
  EXPECT_EQ(change_between({1, 1, 1, {}}, {2, 2, 2, {}}, false).chance, 0) << "no interval at all";
}

TEST(Change, InPercentOnlyOfWhatIsNotZero) {
  EXPECT_FALSE(change_between({0, 0, 0, {}}, {1, 1, 1, {}}, false).percent);
  EXPECT_FALSE(change_between({0.1, -0.1, 0.3, {}}, {1, 1, 1, {}}, false).percent);
  const Change negative = change_between({-10, -11, -9, {}}, {-12, -13, -11, {}}, false);
  EXPECT_DOUBLE_EQ(negative.percent->value, -20);
  EXPECT_LT(negative.percent->low, negative.percent->high);
}

TEST(Change, OfAnglesGoesTheShortWayRound) {
  constexpr double pi = std::numbers::pi;
  const Change turned =
      change_between({pi - 0.1, pi - 0.2, pi, {}}, {-pi + 0.1, -pi, -pi + 0.2, {}}, true);
  EXPECT_NEAR(turned.absolute.value, 0.2, 1e-12);
  EXPECT_FALSE(turned.percent);
}

TEST(Change, IntervalHoldsTheTruthAsOftenAsItSays) {
  statistics::RandomStream random(5, 1);
  constexpr int runs = 20000;
  int held = 0;
  for (int k = 0; k < runs; ++k) {
    const statistics::Estimate a =
        statistics::symmetric_estimate(3 + 0.2 * random.normal(), 1.96 * 0.2);
    const statistics::Estimate b =
        statistics::symmetric_estimate(4 + 0.5 * random.normal(), 1.96 * 0.5);
    const statistics::Estimate change = change_between(a, b, false).absolute;
    if (change.low <= 1 && 1 <= change.high) ++held;
  }
  EXPECT_NEAR(held / static_cast<double>(runs), 0.95, 0.006) << "4 standard errors";
}

TEST(Holm, StepsDown) {
  // Worked by hand: 0.01 * 3, 0.02 * 2, 0.04 * 1.
  EXPECT_EQ(holm_adjusted({0.04, 0.01, 0.02}), (std::vector<double>{0.04, 0.03, 0.04}));
  EXPECT_EQ(holm_adjusted({0.6, 0.9}), (std::vector<double>{1, 1}));
  EXPECT_TRUE(holm_adjusted({}).empty());
}

}  // namespace
}  // namespace tribolog::history::change_test
