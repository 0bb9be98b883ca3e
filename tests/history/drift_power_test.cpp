// What the control charts promise: a slow drift is found, and nothing is found where nothing is.

#include <cstdio>
#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>

#include "history/joint_trend.h"
#include "history/simulated_history.h"

namespace tribolog::history::drift_power_test {
namespace {

using test::HistoryShape;
using test::simulated_history;
using test::unchanged;

constexpr std::size_t runs = 200;

JointTrend trend_of(const std::vector<calibration::Measured>& calibrations) {
  return joint_trends(calibrations, {}).front();
}

const QuantityTrend& quantity(const JointTrend& trend, std::string_view name) {
  for (const QuantityTrend& q : trend.quantities) {
    if (q.name == name) return q;
  }
  throw std::logic_error(std::string(name));
}

/// Joints with any excursion at all, standing or not.
std::size_t false_alarms(std::uint64_t first_seed, std::size_t joints,
                         const test::HistoryShape& shape) {
  std::size_t alarms = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + joints; ++seed) {
    const JointTrend t = trend_of(test::simulated_history(seed, test::unchanged, shape));
    if (t.state() > TrendState::steady) ++alarms;
  }
  return alarms;
}

double three_percent_drift(const std::string& name, std::size_t k, std::size_t calibrations) {
  if (name != "coulomb_torque") return 1;
  return 1 + 0.03 * static_cast<double>(k) / static_cast<double>(calibrations - 1);
}

/// Share of the joints on which the drift of Coulomb torque stands as a warning.
double power(const test::HistoryShape& shape) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    const auto calibrations = test::simulated_history(
        seed,
        [&](const std::string& name, std::size_t k) {
          return three_percent_drift(name, k, shape.calibrations);
        },
        shape);
    const JointTrend t = trend_of(calibrations);
    const QuantityTrend& q = quantity(t, "coulomb_torque");
    if (q.state == TrendState::warning && q.changes.back().direction > 0) ++found;
  }
  return static_cast<double>(found) / runs;
}

TEST(DriftPower, ThreePercentInTwentyCalibrationsAreFound) {
  const double at_half_percent = power({});
  std::printf("drift of 3 %% over 20 calibrations, repeatability 0.5 %%: found in %.1f %% of %zu\n",
              100 * at_half_percent, runs);
  EXPECT_GE(at_half_percent, 0.99);
}

TEST(DriftPower, NoisierJointsNeedMoreCalibrations) {
  test::HistoryShape shape;
  for (const double percent : {0.6, 0.7, 0.8, 1.0}) {
    shape.noise = {0.009 * percent, 0.0044 * percent};
    const double share = power(shape);
    std::printf("repeatability %.1f %%: found in %.1f %%\n", percent, 100 * share);
    EXPECT_GE(share, percent < 0.65 ? 0.9 : 0.2);
  }
  const double in_20 = power(shape);
  shape.calibrations = 60;
  const double in_60 = power(shape);
  std::printf("repeatability 1 %%, the drift over 60 calibrations: found in %.1f %%\n",
              100 * in_60);
  EXPECT_GE(in_60, 0.9);
  EXPECT_GT(in_60, in_20);
}

TEST(DriftPower, TwoHundredJointsWithoutDriftRaiseAtMostTwoAlarms) {
  const std::size_t alarms = false_alarms(1, runs, {});
  std::printf("%zu joints without drift, 20 calibrations, 9 quantities: %zu alarms\n", runs,
              alarms);
  EXPECT_LE(alarms, 2U);
}

// The promise of the header, over enough joints that luck plays no part: 0.4 % expected, 5000
// joints give 20 +- 4.5.
TEST(DriftPower, FalseAlarmsAreAsRareAsPromised) {
  const std::size_t alarms = false_alarms(100000, 5000, {});
  std::printf("5000 joints: %zu alarms\n", alarms);
  EXPECT_LE(alarms, 38U);
  EXPECT_GE(alarms, 1U) << "a chart that cannot alarm finds nothing either";
}

TEST(DriftPower, LongHistoriesStayQuiet) {
  test::HistoryShape shape;
  shape.calibrations = 100;
  const std::size_t alarms = false_alarms(7000, 400, shape);
  std::printf("400 joints of 100 calibrations: %zu alarms\n", alarms);
  EXPECT_LE(alarms, 30U);
}

// Real calibrations go wrong now and then: 3 % of all values with five times the noise.
TEST(DriftPower, WildValuesRaiseFewAlarms) {
  std::size_t alarms = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    auto calibrations = test::simulated_history(seed, test::unchanged);
    statistics::RandomStream random(seed, 77);
    for (calibration::Measured& m : calibrations) {
      for (calibration::Quantity& q : m.quantities) {
        if (random.uniform() > 0.03) continue;
        const double by = 5 * 0.005 * q.estimate->value * random.normal();
        q.estimate = {q.estimate->value + by, q.estimate->low + by, q.estimate->high + by, {}};
      }
    }
    if (trend_of(calibrations).state() > TrendState::apart) ++alarms;
  }
  std::printf("1000 joints with wild values: %zu alarms\n", alarms);
  EXPECT_LE(alarms, 10U);
}

/// A year of 24 calibrations, 15 to 35 °C.
std::vector<double> seasons(std::size_t calibrations, std::uint64_t seed) {
  std::vector<double> all;
  statistics::RandomStream random(seed, 9);
  for (std::size_t k = 0; k < calibrations; ++k) {
    all.push_back(25 + 10 * std::sin(0.26 * static_cast<double>(k)) + 0.5 * random.normal());
  }
  return all;
}

TEST(DriftPower, SeasonsAloneRaiseNoAlarmWhereTheyAreRecorded) {
  std::size_t recorded = 0, unrecorded = 0, slopes = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    test::HistoryShape shape;
    shape.calibrations = 30;
    shape.temperature_C = seasons(shape.calibrations, seed);
    shape.viscous_per_K = -0.01;
    const JointTrend t = trend_of(test::simulated_history(seed, test::unchanged, shape));
    if (t.state() > TrendState::steady) ++recorded;
    const QuantityTrend& viscous = quantity(t, "viscous_coefficient");
    EXPECT_EQ(viscous.temperature, TemperatureUse::corrected);
    EXPECT_EQ(quantity(t, "gravity_torque").temperature, TemperatureUse::hardly_felt);
    const ReferenceLine& line = *viscous.reference;
    if (std::abs(line.slope_per_K / line.level + 0.01) < 0.001) ++slopes;
    shape.is_stated = false;
    const JointTrend blind = trend_of(test::simulated_history(seed, test::unchanged, shape));
    if (quantity(blind, "viscous_coefficient").state > TrendState::steady) ++unrecorded;
  }
  std::printf("seasons of 20 K: %zu alarms of %zu recorded, %zu where not\n", recorded, runs,
              unrecorded);
  EXPECT_LE(recorded, 3U);
  EXPECT_GE(slopes, runs * 95 / 100);
  EXPECT_GE(unrecorded, runs / 4) << "the test would not tell a chart without correction";
}

TEST(DriftPower, ADriftIsFoundBeneathTheSeasons) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    test::HistoryShape shape;
    shape.calibrations = 40;
    shape.temperature_C = seasons(shape.calibrations, seed);
    shape.viscous_per_K = -0.01;
    const auto calibrations = test::simulated_history(
        seed,
        [](const std::string& name, std::size_t k) {
          return name == "viscous_coefficient" ? 1 + 0.003 * static_cast<double>(k) : 1;
        },
        shape);
    const JointTrend t = trend_of(calibrations);
    if (quantity(t, "viscous_coefficient").state == TrendState::warning) ++found;
  }
  std::printf("12 %% over 40 calibrations beneath 20 K: found in %zu of %zu\n", found, runs);
  EXPECT_GE(found, runs * 95 / 100);
}

}  // namespace
}  // namespace tribolog::history::drift_power_test
