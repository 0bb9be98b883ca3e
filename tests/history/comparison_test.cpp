#include "history/comparison.h"

#include <cmath>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "history/history_json.h"
#include "history/simulated_history.h"
#include "wording/words.h"

namespace tribolog::history::comparison_test {
namespace {

using test::simulated_history;
using test::unchanged;

/// Two calibrations of one joint at 25 °C; the second's truth differs as stated.
std::pair<calibration::Measured, calibration::Measured> pair_of(
    std::uint64_t seed, const test::Truth& share = test::unchanged) {
  test::HistoryShape shape;
  shape.calibrations = 2;
  shape.temperature_C = {25, 25};
  shape.noise = {0, 0.0022};  // what the intervals say, and nothing beside
  auto both = test::simulated_history(seed, share, shape);
  return {both[0], both[1]};
}

const ComparedQuantity& quantity(const Comparison& c, std::string_view name) {
  for (const ComparedQuantity& q : c.quantities) {
    if (q.name == name) return q;
  }
  throw std::logic_error(std::string(name));
}

Comparison compared(const std::pair<calibration::Measured, calibration::Measured>& both) {
  return compare(both.first, both.second, {}, false);
}

TEST(Comparison, OfEqualCalibrationsSeesNoChange) {
  auto [a, b] = pair_of(1);
  b.quantities = a.quantities;
  const Comparison c = compare(a, b, {}, false);
  EXPECT_EQ(c.count(ChangeWord::no_change_seen), c.quantities.size());
  for (const ComparedQuantity& q : c.quantities) {
    EXPECT_EQ(q.change->absolute.value, 0) << q.name;
    EXPECT_TRUE(q.cautions.empty()) << wording::words(q.cautions.front());
  }
}

TEST(Comparison, FindsTheChangeThatIsThereAndNoOther) {
  constexpr int pairs = 200;
  int found = 0, held = 0, others = 0;
  for (std::uint64_t seed = 1; seed <= pairs; ++seed) {
    const Comparison c = compared(pair_of(seed, [](const std::string& name, std::size_t k) {
      return name == "coulomb_torque" && k == 1 ? 1.02 : 1.0;
    }));
    const ComparedQuantity& q = quantity(c, "coulomb_torque");
    const statistics::Estimate& percent = *q.change->percent;
    if (q.word == ChangeWord::changed) ++found;
    if (percent.low <= 2 && 2 <= percent.high) ++held;
    if (c.count(ChangeWord::changed) > (q.word == ChangeWord::changed ? 1U : 0U)) ++others;
  }
  EXPECT_GE(found, pairs * 98 / 100) << "2 % are 6.4 standard errors of the change";
  EXPECT_NEAR(held, 0.95 * pairs, 12) << "four standard errors";
  EXPECT_LE(others, 22) << "5 % and four standard errors";
}

// Nine quantities without a change: each of their 95 % intervals leaves out zero in 5 % of the
// pairs, one of nine in 37 %. The word must be wrong in 5 % at most.
TEST(Comparison, ManyQuantitiesDoNotMakeAChangeByChance) {
  constexpr int pairs = 1000;
  int with_word = 0, with_interval = 0;
  for (std::uint64_t seed = 1; seed <= pairs; ++seed) {
    const Comparison c = compared(pair_of(seed));
    if (c.count(ChangeWord::changed) > 0) ++with_word;
    for (const ComparedQuantity& q : c.quantities) {
      if (q.change->absolute.low <= 0 && q.change->absolute.high >= 0) continue;
      ++with_interval;
      break;
    }
  }
  EXPECT_LE(with_word, 72) << "5 % and three standard errors";
  EXPECT_GE(with_word, 20) << "a word that is never given finds nothing";
  EXPECT_GE(with_interval, 300);
}

// A current whose torque constant is not known is no torque: no change is told between the two.
TEST(Comparison, HoldsNoAmperesAgainstNewtonMetres) {
  auto [a, b] = pair_of(1);
  for (calibration::Quantity& q : b.quantities) {
    q.unit = joint::in_amperes(q.unit);
    if (q.unit == "A") q.estimate = statistics::scaled(*q.estimate, 10);
  }
  const Comparison c = compare(a, b, {}, false);
  EXPECT_EQ(quantity(c, "coulomb_torque").word, ChangeWord::not_comparable);
  EXPECT_FALSE(quantity(c, "coulomb_torque").change);
  EXPECT_EQ(wording::words(quantity(c, "coulomb_torque").why_not.back()),
            "the units differ (N·m and A)");
  EXPECT_EQ(quantity(c, "stribeck_speed").word, ChangeWord::no_change_seen);
}

// Another torque constant, of 2 % each: a difference of 2 % is no change of the joint.
TEST(Comparison, AnInfluenceOfAnotherSourceIsInTheChange) {
  auto [a, b] = pair_of(1, [](const std::string& name, std::size_t k) {
    return name == "coulomb_torque" && k == 1 ? 1.02 : 1.0;
  });
  const auto with_sources = [&](const char* first, const char* second) {
    for (auto* const one : {&a, &b}) {
      for (calibration::Quantity& q : one->quantities) {
        if (q.name != "coulomb_torque") continue;
        q.influences = {{"torque_constant", one == &a ? first : second, 0.01 * q.estimate->value}};
      }
    }
    return compare(a, b, {}, false);
  };
  const Comparison shared = with_sources("stand 3", "stand 3");
  EXPECT_EQ(quantity(shared, "coulomb_torque").word, ChangeWord::changed);
  EXPECT_TRUE(quantity(shared, "coulomb_torque").cautions.empty());
  const Comparison apart = with_sources("stand 3", "stand 4");
  EXPECT_EQ(quantity(apart, "coulomb_torque").word, ChangeWord::no_change_seen);
  ASSERT_EQ(quantity(apart, "coulomb_torque").cautions.size(), 1U);
  EXPECT_NE(wording::words(quantity(apart, "coulomb_torque").cautions.front())
                .find("the same torque constant (stand 3; stand 4)"),
            std::string::npos);
  EXPECT_NEAR(quantity(apart, "coulomb_torque").change->percent->half_width(),
              std::hypot(quantity(shared, "coulomb_torque").change->percent->half_width(), 2.8),
              0.05);
  // An older program kept no source.
  EXPECT_EQ(quantity(with_sources("stand 3", ""), "coulomb_torque").word, ChangeWord::changed);
}

TEST(Comparison, TemperatureMattersToFrictionAlone) {
  auto both = pair_of(1);
  both.second.entry.facts.temperature_C = 28.5;
  const Comparison c = compared(both);
  EXPECT_EQ(quantity(c, "coulomb_torque").word, ChangeWord::not_comparable);
  EXPECT_NE(wording::words(quantity(c, "coulomb_torque").why_not.front()).find("3.5 K"),
            std::string::npos);
  EXPECT_EQ(quantity(c, "gravity_torque").word, ChangeWord::no_change_seen);
  EXPECT_EQ(quantity(c, "bristle_stiffness").word, ChangeWord::no_change_seen);
  AllowedDifference wide;
  wide.temperature_K = 4;
  EXPECT_EQ(quantity(compare(both.first, both.second, wide, false), "coulomb_torque").word,
            ChangeWord::no_change_seen);
  both.second.entry.facts.temperature_C.reset();
  const Comparison unknown = compared(both);
  EXPECT_EQ(quantity(unknown, "coulomb_torque").word, ChangeWord::no_change_seen);
  EXPECT_EQ(quantity(unknown, "coulomb_torque").cautions.size(), 1U);
  EXPECT_TRUE(quantity(unknown, "gravity_torque").cautions.empty());
}

TEST(Comparison, PayloadGearAndRateMatterWhereTheyDo) {
  auto both = pair_of(1);
  both.second.entry.facts.payload_kg = 2;
  Comparison c = compared(both);
  EXPECT_EQ(quantity(c, "gravity_torque").word, ChangeWord::not_comparable);
  EXPECT_EQ(quantity(c, "coulomb_torque").word, ChangeWord::no_change_seen);
  EXPECT_EQ(quantity(c, "coulomb_torque").cautions.size(), 1U);
  both = pair_of(1);
  both.second.entry.facts.gear_ratio = 101;
  EXPECT_EQ(compared(both).count(ChangeWord::not_comparable), c.quantities.size());
  both = pair_of(1);
  both.second.entry.facts.sampling_Hz = 250;
  c = compared(both);
  EXPECT_EQ(quantity(c, "bristle_stiffness").word, ChangeWord::not_comparable);
  EXPECT_EQ(quantity(c, "viscous_coefficient").word, ChangeWord::no_change_seen);
}

/// What is said of a payload against none.
std::string payload_words(const std::string& name, std::optional<double> kg,
                          std::optional<double> metres) {
  auto both = pair_of(1);
  both.first.entry.facts.payload.clear();
  both.first.entry.facts.payload_kg.reset();
  both.first.entry.facts.payload_distance_m.reset();
  calibration::Facts& f = both.second.entry.facts;
  f.payload = name;
  f.payload_kg = kg;
  f.payload_distance_m = metres;
  return wording::words(quantity(compared(both), "gravity_torque").why_not.front());
}

TEST(Comparison, PayloadsAreToldAsFarAsTheyAreStated) {
  const auto differ = [](const std::string& second) {
    return "the payloads differ (none stated and " + second + ")";
  };
  EXPECT_EQ(payload_words("gripper", {}, {}), differ("“gripper”"));
  EXPECT_EQ(payload_words("", 2.5, {}), differ("2.5 kg"));
  EXPECT_EQ(payload_words("", {}, 0.3), differ("at 0.3 m"));
  EXPECT_EQ(payload_words("gripper", 2.5, {}), differ("“gripper”, 2.5 kg"));
  EXPECT_EQ(payload_words("gripper", {}, 0.3), differ("“gripper” at 0.3 m"));
  EXPECT_EQ(payload_words("", 2.5, 0.3), differ("2.5 kg at 0.3 m"));
  EXPECT_EQ(payload_words("gripper", 2.5, 0.3), differ("“gripper”, 2.5 kg at 0.3 m"));
}

TEST(Comparison, WhatIsNotUsableIsNotCompared) {
  auto both = pair_of(1);
  both.second.quantities[0].verdict = calibration::Verdict::doubtful;
  both.second.quantities[1].estimate.reset();
  both.second.quantities[1].verdict = calibration::Verdict::not_identifiable;
  const Comparison c = compared(both);
  EXPECT_EQ(c.quantities[0].word, ChangeWord::not_comparable);
  EXPECT_TRUE(c.quantities[0].change) << "shown all the same";
  EXPECT_EQ(c.quantities[1].word, ChangeWord::not_comparable);
  EXPECT_FALSE(c.quantities[1].change);
  EXPECT_EQ(c.count(ChangeWord::no_change_seen), c.quantities.size() - 2);
}

TEST(Comparison, RefusesDifferentJointsUnlessAskedFor) {
  auto both = pair_of(1);
  both.second.entry.facts.of.joint = "J3";
  EXPECT_THROW(compared(both), UsageError);
  const Comparison c = compare(both.first, both.second, {}, true);
  ASSERT_FALSE(c.remarks.empty());
  EXPECT_TRUE(c.remarks.front().is("comparison.different_joints"));
  EXPECT_THROW(compare(both.first, both.first, {}, false), UsageError);
}

TEST(Comparison, JsonHoldsItAll) {
  const auto json = nlohmann::json::parse(comparison_json(compared(pair_of(1))));
  EXPECT_EQ(json["schema"], "tribolog-archive-diff-1");
  EXPECT_EQ(json["quantities"].size(), 9U);
  EXPECT_EQ(json["no_change_seen"], 9);
  EXPECT_EQ(json["quantities"][0]["word"], "no change seen");
  EXPECT_TRUE(json["quantities"][0]["change"]["low"].is_number());
}

}  // namespace
}  // namespace tribolog::history::comparison_test
