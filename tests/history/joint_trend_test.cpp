#include "history/joint_trend.h"

#include <algorithm>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "history/history_json.h"
#include "history/simulated_history.h"

namespace tribolog::history::joint_trend_test {
namespace {

using test::simulated_history;
using test::unchanged;

const QuantityTrend& quantity(const JointTrend& trend, std::string_view name) {
  for (const QuantityTrend& q : trend.quantities) {
    if (q.name == name) return q;
  }
  throw std::logic_error(std::string(name));
}

/// Coulomb torque 8 % more from the calibration with that number on.
test::Truth step_at(std::size_t at) {
  return [at](const std::string& name, std::size_t k) {
    return name == "coulomb_torque" && k >= at ? 1.08 : 1.0;
  };
}

test::HistoryShape of_length(std::size_t calibrations) {
  test::HistoryShape shape;
  shape.calibrations = calibrations;
  return shape;
}

TEST(JointTrend, TellsTheDateAndTheSizeOfAStep) {
  const JointTrend t =
      joint_trends(test::simulated_history(3, step_at(14), of_length(24)), {}).front();
  EXPECT_EQ(t.state(), TrendState::warning);
  const QuantityTrend& q = quantity(t, "coulomb_torque");
  ASSERT_EQ(q.changes.size(), 1U);
  EXPECT_EQ(q.changes.front().from, test::utc_of_day(14 * 14));
  EXPECT_GT(q.changes.front().alarm, q.changes.front().from);
  EXPECT_NEAR(*q.changes.front().percent, 8, 1);
  EXPECT_GT(q.changes.front().size.low, 0);
  EXPECT_EQ(quantity(t, "inertia").state, TrendState::steady);
}

TEST(JointTrend, TellsOfCalibrationsThatStandApartAndOfTheLatest) {
  for (const std::size_t at : {12U, 19U}) {
    const auto odd = [at](const std::string& name, std::size_t k) {
      return name == "coulomb_torque" && k == at ? 1.5 : 1.0;
    };
    const JointTrend t = joint_trends(test::simulated_history(3, odd, of_length(20)), {}).front();
    EXPECT_EQ(t.state(), TrendState::apart);
    const QuantityTrend& q = quantity(t, "coulomb_torque");
    ASSERT_EQ(q.apart.size(), 1U);
    EXPECT_EQ(q.apart.front().at, test::utc_of_day(14 * static_cast<int>(at)));
    EXPECT_NEAR(*q.apart.front().percent, 50, 2);
    EXPECT_EQ(q.apart.front().is_latest, at == 19);
    EXPECT_TRUE(quantity(t, "inertia").apart.empty());
  }
}

TEST(JointTrend, GoesByTimeAndNotByTheOrderOfArrival) {
  auto calibrations = test::simulated_history(3, step_at(14), of_length(24));
  const std::string in_time = trend_json(joint_trends(calibrations, {}));
  std::reverse(calibrations.begin(), calibrations.end());
  EXPECT_EQ(trend_json(joint_trends(calibrations, {})), in_time);
}

TEST(JointTrend, UnequalSpacingChangesDatesAlone) {
  auto calibrations = test::simulated_history(3, step_at(14), of_length(24));
  std::size_t day = 0;
  for (std::size_t k = 0; k < calibrations.size(); ++k) {
    day += 1 + 7 * (k % 5) * (k % 3);
    calibrations[k].entry.facts.measured_at = test::utc_of_day(day);
  }
  const QuantityTrend q = quantity(joint_trends(calibrations, {}).front(), "coulomb_torque");
  EXPECT_EQ(q.changes.front().from, calibrations[14].entry.facts.measured_at);
}

TEST(JointTrend, KeepsJointsApart) {
  auto calibrations = test::simulated_history(3, step_at(14), of_length(24));
  auto other = test::simulated_history(4, test::unchanged, of_length(8));
  for (calibration::Measured& m : other) m.entry.facts.of.joint = "J3";
  calibrations.insert(calibrations.end(), other.begin(), other.end());
  const auto trends = joint_trends(calibrations, {});
  ASSERT_EQ(trends.size(), 2U);
  EXPECT_EQ(trends[0].state(), TrendState::warning);
  EXPECT_EQ(trends[1].calibrations, 8U);
  EXPECT_EQ(trends[1].state(), TrendState::steady);
}

TEST(JointTrend, LeavesOutAndCountsWhatDoesNotBelong) {
  auto calibrations = test::simulated_history(3, test::unchanged, of_length(20));
  calibrations[2].quantities[0].verdict = calibration::Verdict::doubtful;
  calibrations[2].quantities[0].estimate->value *= 3;
  calibrations[2].quantities[0].estimate->high *= 3;
  calibrations[5].quantities[0].verdict = calibration::Verdict::not_identifiable;
  calibrations[5].quantities[0].estimate.reset();
  calibrations[7].entry.facts.gear_ratio = 50;
  calibrations[9].entry.facts.payload_kg = 5;
  const JointTrend t = joint_trends(calibrations, {}).front();
  const QuantityTrend& coulomb = quantity(t, "coulomb_torque");
  EXPECT_EQ(coulomb.count(LeftOut::not_usable), 1U);
  EXPECT_EQ(coulomb.without_estimate, 1U);
  EXPECT_EQ(coulomb.count(LeftOut::other_gear), 1U);
  EXPECT_EQ(coulomb.count(LeftOut::other_payload), 0U);
  EXPECT_EQ(coulomb.count(LeftOut::none), 17U);
  EXPECT_EQ(coulomb.learned + coulomb.judged, 17U);
  EXPECT_EQ(quantity(t, "gravity_torque").count(LeftOut::other_payload), 1U);
  EXPECT_EQ(t.state(), TrendState::steady);
}

TEST(JointTrend, KeepsTheUnitOfTheLatestAndCountsTheOthers) {
  auto calibrations = test::simulated_history(3, test::unchanged, of_length(20));
  for (const std::size_t k : {0U, 4U}) {
    for (calibration::Quantity& q : calibrations[k].quantities) {
      q.unit = joint::in_amperes(q.unit);
      q.estimate = statistics::scaled(*q.estimate, 3);
    }
  }
  const JointTrend t = joint_trends(calibrations, {}).front();
  const QuantityTrend& coulomb = quantity(t, "coulomb_torque");
  EXPECT_EQ(coulomb.unit, "N·m");
  EXPECT_EQ(coulomb.in_another_unit, 2U);
  EXPECT_EQ(coulomb.points.size(), 18U);
  EXPECT_EQ(coulomb.calibrations(), 20U);
  EXPECT_EQ(coulomb.state, TrendState::steady);
}

TEST(JointTrend, FewCalibrationsSaySo) {
  const JointTrend t =
      joint_trends(test::simulated_history(3, step_at(3), of_length(6)), {}).front();
  EXPECT_EQ(t.state(), TrendState::too_few);
  EXPECT_EQ(t.watched, 0U);
  EXPECT_FALSE(quantity(t, "coulomb_torque").points.front().chart.is_judged);
}

TEST(JointTrend, BaselineByCountAndByDate) {
  const auto calibrations = test::simulated_history(3, step_at(14), of_length(30));
  Baseline ten;
  ten.count = 10;
  EXPECT_EQ(quantity(joint_trends(calibrations, ten).front(), "coulomb_torque").learned, 10U);
  Baseline dates;
  dates.from = test::utc_of_day(14 * 14).substr(0, 10);
  dates.to = test::utc_of_day(14 * 21).substr(0, 10);
  const JointTrend of_dates = joint_trends(calibrations, dates).front();
  const QuantityTrend& later = quantity(of_dates, "coulomb_torque");
  EXPECT_EQ(later.count(LeftOut::before_baseline), 14U);
  EXPECT_EQ(later.learned, 8U);
  EXPECT_EQ(later.state, TrendState::steady) << "the step lies before";
  Baseline short_one;
  short_one.count = 3;
  EXPECT_THROW(joint_trends(calibrations, short_one), UsageError);
  Baseline no_date;
  no_date.from = "last spring";
  EXPECT_THROW(joint_trends(calibrations, no_date), UsageError);
}

TEST(JointTrend, TemperatureThatHardlyVariedIsNotCorrectedFor) {
  test::HistoryShape shape = of_length(20);
  for (std::size_t k = 0; k < 20; ++k) {
    shape.temperature_C.push_back(25 + 0.05 * static_cast<double>(k % 4));
  }
  const JointTrend t = joint_trends(test::simulated_history(3, test::unchanged, shape), {}).front();
  EXPECT_EQ(quantity(t, "coulomb_torque").temperature, TemperatureUse::too_even);
  EXPECT_EQ(quantity(t, "coulomb_torque").reference->slope_per_K, 0);
  const JointTrend blind =
      joint_trends(test::simulated_history(3, test::unchanged, of_length(20)), {}).front();
  EXPECT_EQ(quantity(blind, "coulomb_torque").temperature, TemperatureUse::not_recorded);
}

TEST(JointTrend, WarmingAlongWithTimeIsACaution) {
  test::HistoryShape shape = of_length(20);
  for (std::size_t k = 0; k < 20; ++k) {
    shape.temperature_C.push_back(20 + static_cast<double>(k));
  }
  const JointTrend t = joint_trends(test::simulated_history(3, test::unchanged, shape), {}).front();
  ASSERT_EQ(t.cautions.size(), 1U);
  EXPECT_TRUE(t.cautions.front().is("trend.warming"));
}

TEST(JointTrend, ASlowDriftIsToldAsOne) {
  test::HistoryShape shape = of_length(24);
  shape.noise = {0.004, 0.004};
  const auto drift = [](const std::string& name, std::size_t k) {
    return name == "coulomb_torque" ? 1 - 0.02 * static_cast<double>(k) / 23 : 1;
  };
  const auto trends = joint_trends(test::simulated_history(5, drift, shape), {});
  const QuantityTrend& coulomb = quantity(trends.front(), "coulomb_torque");
  ASSERT_EQ(coulomb.state, TrendState::warning);
  ASSERT_EQ(coulomb.changes.size(), 1U);
  const FoundChange& change = coulomb.changes.front();
  EXPECT_TRUE(change.is_slow);
  EXPECT_EQ(change.direction, -1);
  EXPECT_LT(change.size.low, -0.02 * 0.45);
  EXPECT_GT(change.size.high, -0.02 * 0.45);
  ASSERT_TRUE(change.percent);
  EXPECT_NEAR(*change.percent, -2, 1);
  EXPECT_NEAR(change.drift_start, 0.45, 0.01);
  EXPECT_EQ(change.from, coulomb.points.front().measured_at);
  const auto json = nlohmann::json::parse(trend_json(trends));
  const auto& told = json["joints"][0]["quantities"][0]["changes"][0];
  EXPECT_EQ(told["kind"], "drift");
  EXPECT_EQ(told["since"], change.from);
  EXPECT_EQ(told["visible_from"], change.alarm);
}

TEST(JointTrend, ADriftSaysWhenItReachesALimit) {
  constexpr std::size_t count = 24;
  constexpr double days_between = 14;
  test::HistoryShape shape = of_length(count);
  shape.noise = {0.002, 0.002};
  const auto drift = [](const std::string& name, std::size_t k) {
    return name == "coulomb_torque" ? 1 + 0.04 * static_cast<double>(k) / (count - 1) : 1;
  };
  std::size_t inside = 0;
  constexpr std::size_t histories = 20;
  for (std::size_t seed = 0; seed < histories; ++seed) {
    auto trends = joint_trends(test::simulated_history(seed, drift, shape), {});
    EXPECT_FALSE(quantity(trends.front(), "coulomb_torque").changes.front().limit);
    history::state_limits(trends, 10);
    const FoundChange& change = quantity(trends.front(), "coulomb_torque").changes.front();
    ASSERT_TRUE(change.limit);
    // 4 % over 23 intervals: 10 % two and a half times as late.
    const std::string truth =
        test::utc_of_day(static_cast<int>(days_between * (count - 1) * 2.5)).substr(0, 10);
    EXPECT_LT(change.limit->earliest, change.limit->expected);
    EXPECT_LT(change.limit->expected, change.limit->latest);
    if (change.limit->earliest <= truth && truth <= change.limit->latest) ++inside;
    const auto json = nlohmann::json::parse(trend_json(trends));
    const auto& stated = json["joints"][0]["quantities"][0]["changes"][0]["limit"];
    EXPECT_EQ(stated["percent"], 10);
    EXPECT_EQ(stated["latest_on"], change.limit->latest);
  }
  EXPECT_GE(inside, histories * 17 / 20);
  // A drift whose slow end stands still never gets there; one of another millennium neither.
  auto trends = joint_trends(test::simulated_history(1, drift, shape), {});
  history::state_limits(trends, 1000);
  const FoundChange& change = quantity(trends.front(), "coulomb_torque").changes.front();
  EXPECT_LT(change.limit->expected, "2999");
}

TEST(JointTrend, JsonHoldsItAll) {
  const auto json = nlohmann::json::parse(
      trend_json(joint_trends(test::simulated_history(3, step_at(14), of_length(24)), {})));
  EXPECT_EQ(json["schema"], "tribolog-archive-trend-1");
  EXPECT_EQ(json["joints"][0]["state"], "warning");
  const auto& coulomb = json["joints"][0]["quantities"][0];
  EXPECT_EQ(coulomb["changes"][0]["visible_from"], test::utc_of_day(14 * 14));
  EXPECT_TRUE(coulomb["changes"][0]["back_from"].is_null());
  EXPECT_EQ(coulomb["points"].size(), 24U);
  EXPECT_TRUE(coulomb["points"][0]["score"].is_null());
  EXPECT_TRUE(coulomb["points"][20]["score"].is_number());
}

}  // namespace
}  // namespace tribolog::history::joint_trend_test
