// Means of groups that differ: their truth is covered as often as stated, and groups that do not
// differ are left to the plain mean.

#include "statistics/group_mean.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::group_mean_test {
namespace {

using Groups = std::vector<std::vector<double>>;

Groups drawn(std::uint64_t seed, std::size_t groups, std::size_t members, double between,
             double within) {
  statistics::RandomStream random(seed, 0);
  Groups all(groups);
  for (std::vector<double>& group : all) {
    const double effect = between * random.normal();
    for (std::size_t k = 0; k < members; ++k) {
      group.push_back(1 + effect + within * random.normal());
    }
  }
  return all;
}

TEST(GroupMean, CoversTheMeanOfAllGroupsThereCouldBe) {
  constexpr int seeds = 400;
  int found = 0;
  int covered = 0;
  double between = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto mean = statistics::mean_of_groups_that_differ(
        drawn(static_cast<std::uint64_t>(seed), 6, 3, 0.05, 0.005));
    if (!mean) continue;
    ++found;
    covered += std::abs(mean->mean - 1) <= mean->half_width ? 1 : 0;
    between += mean->between_sd / seeds;
  }
  EXPECT_EQ(found, seeds);
  EXPECT_NEAR(covered, 0.95 * seeds, 3 * std::sqrt(0.95 * 0.05 * seeds));
  EXPECT_NEAR(between, 0.05, 0.005);
}

TEST(GroupMean, OfGroupsThatAreAlikeIsSeldomTaken) {
  constexpr int seeds = 400;
  int taken = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    taken += statistics::mean_of_groups_that_differ(
                 drawn(static_cast<std::uint64_t>(seed), 4, 3, 0, 0.01))
                 ? 1
                 : 0;
  }
  EXPECT_LT(taken, 0.09 * seeds);
}

TEST(GroupMean, NeedsGroupsAndTheirOwnScatter) {
  EXPECT_FALSE(statistics::mean_of_groups_that_differ({}));
  EXPECT_FALSE(statistics::mean_of_groups_that_differ({{1, 1.1, 0.9}}));
  EXPECT_FALSE(statistics::mean_of_groups_that_differ({{1}, {2}, {3}}));
  EXPECT_FALSE(statistics::mean_of_groups_that_differ({{1, 1}, {2, 2}}));
}

/// Two that differ say little of what others would be.
TEST(GroupMean, OfTwoGroupsIsHardlyKnown) {
  const auto mean = statistics::mean_of_groups_that_differ({{1.00, 1.01}, {1.10, 1.11}});
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->mean, 1.055, 1e-9);
  EXPECT_NEAR(mean->largest_off, 0.05, 1e-9);
  EXPECT_GT(mean->half_width, 0.6);
}

}  // namespace
}  // namespace tribolog::group_mean_test
