// Friction at speeds over the years: what changed is found with its size and its kind, and a joint
// that does not change is left alone.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "calibration/friction_speeds.h"
#include "history/comparison.h"
#include "history/joint_trend.h"
#include "history/simulated_history.h"

namespace tribolog::history::friction_watch_test {
namespace {

constexpr double standard_speeds[] = {0.3, 1, 3, 10, 30, 100, 300};

/// Friction at the standard speeds beside the other quantities: 0.2 % that a calibration has at all
/// speeds, 0.1 % at each; its interval states 0.15 %.
std::vector<calibration::Measured> friction_history(
    std::uint64_t seed, std::size_t calibrations,
    const std::function<double(std::size_t calibration)>& share) {
  test::HistoryShape shape;
  shape.calibrations = calibrations;
  auto all = test::simulated_history(seed, test::unchanged, shape);
  statistics::RandomStream random(seed, 31);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double common = 1 + 0.002 * random.normal();
    for (const double speed : standard_speeds) {
      const double usual = 0.4 + 0.5 * std::exp(-speed / 5) + 0.02 * std::sqrt(speed);
      const double value = usual * share(k) * common * (1 + 0.001 * random.normal());
      all[k].quantities.push_back({calibration::friction_name(speed), "Friction", "N·m",
                                   calibration::Verdict::usable,
                                   statistics::symmetric_estimate(value, 0.003 * usual)});
    }
  }
  return all;
}

struct Seen {
  std::size_t drifts{};  ///< Speeds of friction.
  std::size_t shifts{};
  double percent{};  ///< Mean over them.
  std::string from;
};

Seen friction_changes(const std::vector<calibration::Measured>& calibrations) {
  Seen seen;
  const std::vector<JointTrend> trends = joint_trends(calibrations, {});
  for (const QuantityTrend& q : trends.front().quantities) {
    if (!calibration::speed_of_friction(q.name) || q.state != TrendState::warning) continue;
    const FoundChange& change = q.changes.back();
    ++(change.is_slow ? seen.drifts : seen.shifts);
    seen.percent += change.percent.value_or(0);
    seen.from = std::max(seen.from, change.from);
  }
  if (seen.drifts + seen.shifts > 0) {
    seen.percent /= static_cast<double>(seen.drifts + seen.shifts);
  }
  return seen;
}

constexpr std::size_t joints = 200;

// What a reader met: 3 % in a year of months was "no change seen".
TEST(FrictionWatch, ThreePercentOverTwelveCalibrationsAreADriftOfThreePercent) {
  std::size_t found = 0;
  std::size_t right = 0;
  for (std::uint64_t seed = 1; seed <= joints; ++seed) {
    const Seen seen = friction_changes(friction_history(
        seed, 12, [](std::size_t k) { return 1 + 0.03 * static_cast<double>(k) / 11; }));
    if (seen.drifts < 4) continue;
    ++found;
    if (std::abs(seen.percent - 3) <= 0.5 && seen.from == test::utc_of_day(0)) ++right;
  }
  std::printf("3 %% over 12: a drift in %zu of %zu, of 3 +- 0.5 %% in %zu\n", found, joints, right);
  EXPECT_GE(found, joints * 95 / 100);
  EXPECT_GE(right, found * 95 / 100);
}

TEST(FrictionWatch, OnePercentOverTwentyFourIsFound) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= joints; ++seed) {
    const Seen seen = friction_changes(friction_history(
        seed, 24, [](std::size_t k) { return 1 + 0.01 * static_cast<double>(k) / 23; }));
    if (seen.drifts + seen.shifts >= 4 && std::abs(seen.percent - 1) <= 0.5) ++found;
  }
  std::printf("1 %% over 24: found in %zu of %zu\n", found, joints);
  EXPECT_GE(found, joints * 80 / 100);
}

TEST(FrictionWatch, AStepIsNoDrift) {
  std::size_t shifts = 0;
  for (std::uint64_t seed = 1; seed <= joints; ++seed) {
    const Seen seen = friction_changes(
        friction_history(seed, 20, [](std::size_t k) { return k < 10 ? 1 : 1.03; }));
    if (seen.shifts >= 4 && seen.drifts == 0 && std::abs(seen.percent - 3) <= 0.5 &&
        seen.from == test::utc_of_day(14 * 10)) {
      ++shifts;
    }
  }
  std::printf("step of 3 %%: a shift of 3 +- 0.5 %% from its day in %zu of %zu\n", shifts, joints);
  EXPECT_GE(shifts, joints * 95 / 100);
}

// One calibration of a warm day is no change that stands.
TEST(FrictionWatch, ASingleWarmDayIsNoChange) {
  std::size_t changes = 0;
  for (std::uint64_t seed = 1; seed <= joints; ++seed) {
    const Seen seen = friction_changes(
        friction_history(seed, 20, [](std::size_t k) { return k == 12 ? 0.96 : 1; }));
    if (seen.drifts + seen.shifts > 0) ++changes;
  }
  std::printf("one calibration 4 %% lower: a standing change in %zu of %zu\n", changes, joints);
  EXPECT_LE(changes, joints * 2 / 100);
}

TEST(FrictionWatch, JointsThatDoNotChangeAreLeftAlone) {
  constexpr std::size_t many = 1000;
  std::size_t alarms = 0;
  for (std::uint64_t seed = 1; seed <= many; ++seed) {
    const Seen seen =
        friction_changes(friction_history(5000 + seed, 12, [](std::size_t) { return 1; }));
    if (seen.drifts + seen.shifts > 0) ++alarms;
  }
  std::printf("%zu joints of 12 calibrations without a change: %zu alarms\n", many, alarms);
  EXPECT_LE(alarms, many / 100);
}

// First against last: what both intervals hold, paired speed by speed.
TEST(FrictionWatch, TheLastAgainstTheFirst) {
  std::size_t found = 0;
  const auto changed = [](const std::vector<calibration::Measured>& all) {
    const Comparison made = compare(all.front(), all.back(), {}, false);
    return std::count_if(made.quantities.begin(), made.quantities.end(), [](const auto& q) {
      return calibration::speed_of_friction(q.name) && q.word == ChangeWord::changed;
    });
  };
  for (std::uint64_t seed = 1; seed <= joints; ++seed) {
    const auto drift = [](std::size_t k) { return 1 + 0.03 * static_cast<double>(k) / 11; };
    if (changed(friction_history(seed, 12, drift)) >= 6) ++found;
  }
  std::printf("3 %% from first to last: changed in %zu of %zu\n", found, joints);
  EXPECT_EQ(found, joints);
}

TEST(StandardSpeeds, LieBetweenTheRecordedOnes) {
  std::vector<calibration::FrictionAtSpeed> all;
  for (const double speed : {0.29, 0.5, 2.0, 29.99}) {
    all.push_back({speed,
                   calibration::Verdict::usable,
                   statistics::symmetric_estimate(1 + std::log(speed), 0.1),
                   {}});
  }
  all[2].verdict = calibration::Verdict::doubtful;
  const auto made = calibration::at_standard_speeds(all);
  ASSERT_EQ(made.size(), 5U);
  const double wanted[] = {0.3, 1, 3, 10, 30};
  for (std::size_t k = 0; k < made.size(); ++k) {
    EXPECT_EQ(made[k].speed_rad_s, wanted[k]);
    EXPECT_NEAR(made[k].torque_Nm.value, 1 + std::log(wanted[k]), 1e-3);
    const auto name = calibration::friction_name(wanted[k]);
    EXPECT_EQ(calibration::speed_of_friction(name), wanted[k]) << name;
  }
  EXPECT_EQ(made[0].verdict, calibration::Verdict::usable);
  EXPECT_EQ(made[1].verdict, calibration::Verdict::doubtful);
  EXPECT_EQ(made[2].verdict, calibration::Verdict::doubtful);
  EXPECT_FALSE(calibration::speed_of_friction("coulomb_torque"));
  EXPECT_FALSE(calibration::speed_of_friction("friction_at_x"));
  EXPECT_TRUE(calibration::at_standard_speeds({}).empty());
}

}  // namespace
}  // namespace tribolog::history::friction_watch_test
