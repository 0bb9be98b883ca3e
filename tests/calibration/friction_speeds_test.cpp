#include "calibration/friction_speeds.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace tribolog::calibration::friction_speeds_test {
namespace {

std::vector<FrictionAtSpeed> of_verdicts(const std::vector<Verdict>& verdicts) {
  std::vector<FrictionAtSpeed> all;
  for (const Verdict verdict : verdicts) {
    const double speed_rad_s = 1 + static_cast<double>(all.size());
    all.push_back({speed_rad_s, verdict, {2, 1, 3, {}}, {}});
  }
  return all;
}

TEST(EvenlyInLog, TakesTheSpeedsNearestToEqualRatios) {
  std::vector<double> speeds_rad_s;
  for (int k = 0; k <= 100; ++k) speeds_rad_s.push_back(std::pow(10, -2 + k / 25.0));
  const std::vector<std::size_t> chosen{0, 25, 50, 75, 100};  // 0.01, 0.1, 1, 10 and 100 rad/s
  EXPECT_EQ(evenly_in_log(speeds_rad_s, 5), chosen);
}

TEST(EvenlyInLog, TakesNoSpeedTwice) {
  EXPECT_EQ(evenly_in_log(std::vector<double>{1, 100}, 5), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(evenly_in_log(std::vector<double>{3}, 5), (std::vector<std::size_t>{0}));
  EXPECT_EQ(evenly_in_log(std::vector<double>{1, 2, 4}, 1), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(evenly_in_log(std::vector<double>{}, 5).empty());
  EXPECT_TRUE(evenly_in_log(std::vector<double>{1, 2}, 0).empty());
}

TEST(FrictionAtTheJoint, TakesTheSamePower) {
  for (const double n : {50.0, -50.0}) {
    const FrictionAtSpeed there = at_joint({10, Verdict::usable, {2, 1, 3, {}}, {}}, n);
    EXPECT_NEAR(there.speed_rad_s * there.torque_Nm.value, 10 * 2, 1e-12);
    EXPECT_NEAR(there.speed_rad_s, 0.2, 1e-12);
    EXPECT_NEAR(there.torque_Nm.low, 50, 1e-12);
    EXPECT_NEAR(there.torque_Nm.high, 150, 1e-12);
  }
}

TEST(UsableRanges, AreTheLongestWithoutAGap) {
  using enum Verdict;
  const auto all = of_verdicts(
      {usable, usable, not_identifiable, usable, doubtful, usable, usable, usable, doubtful});
  const auto ranges = usable_ranges(all, 2);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_EQ(ranges[0].low_rad_s, 1);
  EXPECT_EQ(ranges[0].high_rad_s, 2);
  EXPECT_EQ(ranges[1].low_rad_s, 6);
  EXPECT_EQ(ranges[1].high_rad_s, 8);
  ASSERT_EQ(usable_ranges(all, 1).size(), 1U);
  EXPECT_EQ(usable_ranges(all, 1)[0].low_rad_s, 6);
  EXPECT_EQ(usable_ranges(all, 9).size(), 3U);
  EXPECT_TRUE(usable_ranges(of_verdicts({doubtful, not_identifiable}), 2).empty());
  EXPECT_TRUE(usable_ranges({}, 2).empty());
}

TEST(StatedSpeeds, AreMadeOfTheirNeighboursAndReplaceTheTable) {
  using enum Verdict;
  auto all = of_verdicts({usable, usable, doubtful});
  all[1].torque_Nm = {4, 3, 5, {}};
  const auto made = with_stated_speeds(all, {0.5, std::sqrt(2.0), 2, 2.5, 9});
  ASSERT_EQ(made.size(), 5U);
  EXPECT_EQ(made[1].speed_rad_s, std::sqrt(2.0));
  EXPECT_NEAR(made[1].torque_Nm.value, 3, 1e-12);
  EXPECT_NEAR(made[1].torque_Nm.high, 4, 1e-12);
  EXPECT_EQ(made[3].verdict, doubtful);
  const auto table = of_a_table(made);
  ASSERT_EQ(table.size(), 3U);
  EXPECT_EQ(table[0].speed_rad_s, std::sqrt(2.0));
  EXPECT_EQ(table[1].speed_rad_s, 2);
  EXPECT_EQ(table[2].speed_rad_s, 2.5);
  auto read = made;
  for (FrictionAtSpeed& f : read) f.is_stated = false;
  EXPECT_EQ(of_a_table(read).size(), 5U);
  mark_stated_speeds({2}, read);
  EXPECT_EQ(of_a_table(read).size(), 1U);
}

}  // namespace
}  // namespace tribolog::calibration::friction_speeds_test
