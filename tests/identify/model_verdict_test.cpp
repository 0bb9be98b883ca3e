// What the model's numbers are good for: by the need, and by what contradicts them.

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "calibration/calibration.h"
#include "verdict/effect_findings.h"
#include "verdict/model_verdicts.h"
#include "verdict/quantity_rooms.h"
#include "verdict/rules.h"

namespace tribolog::model_verdict_test {
namespace {

using calibration::Calibration;
using calibration::FrictionAtSpeed;
using calibration::QuantityVerdict;
using calibration::Verdict;
using joint::Quantity;
using method::checks::CheckName;
using method::checks::CheckState;
using method::model::ModelQuantity;

ModelQuantity number(std::optional<Quantity> quantity, double estimate, double half_width,
                     double speed_rad_s = 0) {
  return {quantity,         speed_rad_s, estimate, estimate - half_width, estimate + half_width,
          {{"offset", 0.8}}};
}

/// Friction within 2, 9, 11 and 150 %, and a Coulomb torque within 9 %.
Calibration measured() {
  Calibration c;
  c.manifest.drive = joint::Drive(50, joint::EffortKind::motor_torque, joint::Side::motor);
  c.model.quantities = {number(Quantity::coulomb_torque, 10, 0.9), number({}, 10, 0.2, 1),
                        number({}, 10, 0.9, 2), number({}, 10, 1.1, 4), number({}, 10, 15, 8)};
  c.model.effects = {{"offset", 10, 1, 0.1, {0.2, 0.1, 0.3, {}}, 0.2}};
  return c;
}

std::vector<Verdict> verdicts_on(const Calibration& c,
                                 const std::vector<verdict::BrokenRule>& broken) {
  std::vector<Verdict> all;
  for (const FrictionAtSpeed& f : verdict::friction_at_speeds(c, broken)) {
    EXPECT_EQ(f.reason.empty(), f.verdict == Verdict::usable) << f.speed_rad_s;
    all.push_back(f.verdict);
  }
  return all;
}

std::vector<Verdict> verdicts_on(const Calibration& c) {
  return verdicts_on(c, verdict::apply_rules(c).broken);
}

const std::vector<Verdict> by_need{Verdict::usable, Verdict::usable, Verdict::doubtful,
                                   Verdict::not_identifiable};
const std::vector<Verdict> doubtful{Verdict::doubtful, Verdict::doubtful, Verdict::doubtful,
                                    Verdict::not_identifiable};

TEST(ModelVerdict, FrictionAtSpeedsIsUsableByItsWidth) {
  const Calibration c = measured();
  EXPECT_EQ(verdicts_on(c), by_need);
  const std::vector<FrictionAtSpeed> all = verdict::friction_at_speeds(c, {});
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[2].speed_rad_s, 4);
  EXPECT_EQ(all[2].torque_Nm.value, 10);
  EXPECT_EQ(all[2].torque_Nm.low, 8.9);
  EXPECT_EQ(all[2].torque_Nm.high, 11.1);
}

TEST(ModelVerdict, AnEffortThatNobodyConfirmedMakesAllDoubtful) {
  Calibration c = measured();
  method::checks::DataCheck check;
  check.name = CheckName::effort_provenance;
  check.state = CheckState::fails;
  check.found = {"model.negative_friction"};
  c.data_checks.checks = {check};
  EXPECT_EQ(verdicts_on(c), doubtful);
  c.data_checks.checks[0].state = CheckState::passed;
  EXPECT_EQ(verdicts_on(c), by_need);
}

TEST(ModelVerdict, WhatIntervalsHoldIsNoContradiction) {
  const Calibration c = measured();
  for (const verdict::Rule& rule : verdict::rules()) {
    const bool is_beyond = std::count(rule.beyond_intervals.begin(), rule.beyond_intervals.end(),
                                      Quantity::viscous_curve) > 0;
    const std::vector<Verdict> found =
        verdicts_on(c, {{&rule, {"model.negative_friction"}, {"record.runs"}}});
    if (!is_beyond) {
      EXPECT_EQ(found, by_need);
    } else if (rule.lowers_to == Verdict::doubtful) {
      EXPECT_EQ(found, doubtful);
    } else {
      EXPECT_EQ(found, std::vector<Verdict>(4, Verdict::not_identifiable));
    }
  }
}

/// Each row of the table of rules lowers what it says, and no other quantity.
TEST(Rules, LowerWhatTheyTouch) {
  std::set<std::string> names;
  for (const verdict::Rule& rule : verdict::rules()) {
    const verdict::RuleNumber* number = rule.number();
    const std::string name = number != nullptr ? number->name : "of a check";
    if (number != nullptr) {
      EXPECT_TRUE(names.insert(name).second) << name;
      EXPECT_TRUE(number->measure != nullptr) << name;
      EXPECT_TRUE(rule.lowers_to == Verdict::usable || !rule.experiment.empty()) << name;
    }
    for (const Quantity q : rule.beyond_intervals) {
      EXPECT_EQ(std::count(rule.quantities.begin(), rule.quantities.end(), q), 1) << name;
    }
    std::vector<QuantityVerdict> all(static_cast<std::size_t>(Quantity::viscous_curve) + 1);
    for (std::size_t k = 0; k < all.size(); ++k) all[k].quantity = static_cast<Quantity>(k);
    verdict::lower_by_rules({{&rule, {"model.negative_friction"}, {"record.runs"}}}, all);
    for (const QuantityVerdict& q : all) {
      const bool is_touched =
          std::count(rule.quantities.begin(), rule.quantities.end(), q.quantity) > 0;
      EXPECT_EQ(q.verdict, is_touched ? rule.lowers_to : Verdict::usable)
          << name << " " << to_string(q.quantity);
    }
  }
}

/// Of a calibration without any data no rule is broken.
TEST(Rules, SayNothingOfNothing) {
  const verdict::AppliedRules applied = verdict::apply_rules({});
  EXPECT_TRUE(applied.broken.empty());
  for (const calibration::RuleOutcome& one : applied.outcomes) {
    EXPECT_NE(one.state, calibration::RuleState::broken) << one.rule;
  }
}

TEST(ModelVerdict, DataThatTheModelDoesNotFitMakeAllDoubtful) {
  Calibration c = measured();
  c.model.cells_far_off = 0.03;
  EXPECT_EQ(verdicts_on(c), by_need);
  c.model.cells_far_off = 0.05;
  EXPECT_EQ(verdicts_on(c), doubtful);
  c = measured();
  c.model.unlike_left = 1;
  EXPECT_EQ(verdicts_on(c), doubtful);
  c = measured();
  c.model.quantities[0] = number(Quantity::coulomb_torque, -10, 1);
  EXPECT_EQ(verdicts_on(c), doubtful);
  c = measured();
  c.model.effects[0].size_of_cap = 0.9;
  EXPECT_EQ(verdicts_on(c), doubtful) << "an effect larger than the catalogue knows";
  c.model.effects[0].chi2 = 1;
  EXPECT_EQ(verdicts_on(c), by_need) << "not shown by the data";
}

Verdict coulomb_with(std::optional<double> percent, std::optional<double> half_width_Nm = {}) {
  Calibration c = measured();
  joint::AcceptanceLimit limit;
  limit.quantity = "coulomb_joint_Nm";
  limit.half_width_percent = percent;
  limit.half_width = half_width_Nm;
  if (percent || half_width_Nm) c.manifest.limits = {limit};
  QuantityVerdict q;
  q.quantity = Quantity::coulomb_torque;
  q.verdict = Verdict::not_identifiable;
  std::vector<QuantityVerdict> quantities{q};
  for (const Quantity other : {Quantity::cog_angle, Quantity::gravity_torque, Quantity::inertia,
                               Quantity::viscous_coefficient}) {
    quantities.push_back(q);
    quantities.back().quantity = other;
  }
  verdict::state_by_model(c, {}, quantities);
  EXPECT_TRUE(quantities[0].estimate.has_value());
  EXPECT_EQ(quantities[1].verdict, Verdict::not_identifiable) << "the model says nothing of it";
  return quantities[0].verdict;
}

TEST(ModelVerdict, LimitsOfTheManifestAreTheNeed) {
  EXPECT_EQ(coulomb_with({}), Verdict::usable);
  EXPECT_EQ(coulomb_with(8.0), Verdict::doubtful);
  EXPECT_EQ(coulomb_with(9.5), Verdict::usable);
  // 0.9 N·m at the motor is 45 N·m at the joint.
  EXPECT_EQ(coulomb_with({}, 44.0), Verdict::doubtful);
  EXPECT_EQ(coulomb_with({}, 46.0), Verdict::usable);
}

TEST(ModelVerdict, TheModelsNumberIsTheOneThatIsStated) {
  const Calibration c = measured();
  QuantityVerdict q;
  q.quantity = Quantity::coulomb_torque;
  q.estimate = statistics::Estimate{12, 11.5, 12.5, {}};
  std::vector<QuantityVerdict> quantities{q};
  verdict::state_by_model(c, {}, quantities);
  EXPECT_EQ(quantities[0].estimate->value, c.model.find(Quantity::coulomb_torque)->estimate);
}

using method::hysteresis::LuGreParameterName;

/// Loops with a stiffness and a damping of these half widths, most of them from the motor's turn,
/// and a level of 1 within 0.02 N·m; ramps by which the break-away torque is `ramps_Nm`.
std::vector<QuantityVerdict> of_contacts(double stiffness_percent, double damping_percent,
                                         const statistics::Estimate& ramps_Nm) {
  Calibration c = measured();
  c.lugre.emplace();
  c.lugre->converged = true;
  for (const auto& [name, half_width] :
       {std::pair(LuGreParameterName::bristle_stiffness, stiffness_percent / 100),
        std::pair(LuGreParameterName::bristle_damping, damping_percent / 100),
        std::pair(LuGreParameterName::static_torque, 0.02)}) {
    method::hysteresis::LuGreParameter& parameter = c.lugre->parameters.emplace_back();
    parameter.name = name;
    parameter.estimate = statistics::symmetric_estimate(1, half_width);
    parameter.shares = {{"motor_turn", 0.7}, {"load", 0.1}};
  }
  c.break_away.ramps.resize(4);
  c.break_away.mean_Nm = ramps_Nm;
  std::vector<QuantityVerdict> all = verdict::bristle_verdicts(c);
  verdict::doubt_wide_contacts(c, all);
  return all;
}

TEST(ModelVerdict, WhatLoopsShowIsUsableByTheNeedAndTheWidestEffectIsTheCause) {
  const statistics::Estimate ramps = statistics::symmetric_estimate(1, 0.05);
  auto narrow = of_contacts(9, 35, ramps);
  EXPECT_EQ(verdict::verdict_on(Quantity::bristle_stiffness, narrow).verdict, Verdict::usable);
  auto wide = of_contacts(12, 45, ramps);
  const QuantityVerdict& stiffness = verdict::verdict_on(Quantity::bristle_stiffness, wide);
  EXPECT_EQ(stiffness.verdict, Verdict::doubtful);
  ASSERT_FALSE(stiffness.reasons.empty());
  EXPECT_NE(as_code(stiffness.reasons.back()).find("effect.motor_turn"), std::string::npos);
  EXPECT_EQ(verdict::verdict_on(Quantity::bristle_damping, wide).verdict, Verdict::doubtful);
}

TEST(ModelVerdict, BreakAwayIsOfRampsAndLoopsTogetherWhereTheyAgree) {
  auto agree = of_contacts(5, 20, statistics::symmetric_estimate(1.06, 0.08));
  const statistics::Estimate both =
      *verdict::verdict_on(Quantity::break_away_torque, agree).estimate;
  EXPECT_GT(both.value, 1);
  EXPECT_LT(both.value, 1.01);
  EXPECT_GT(both.half_width(), 0.02);
  EXPECT_LT(both.half_width(), 0.03);
  auto disagree = of_contacts(5, 20, statistics::symmetric_estimate(1.2, 0.08));
  const statistics::Estimate either =
      *verdict::verdict_on(Quantity::break_away_torque, disagree).estimate;
  EXPECT_EQ(either.value, 1.2);
  EXPECT_LT(either.low, 0.981);
}

TEST(ModelVerdict, EffectsBeyondDoubtAreToldTheLargestFirst) {
  Calibration c = measured();
  c.model.friction_Nm = 4;
  c.model.effects = {{"load", 11, 1, 0.1, {0.2, 0.1, 0.3, {}}, 0.1},
                     {"position", 49, 5, 1, {2, 1, 3, {}}, 0.1},
                     {"offset", 20, 1, 1, {0.8, 0.6, 1, {}}, 0.1},
                     {"friction_of_session", std::nan(""), 1, 1, {2, 1, 3, {}}, 0.1}};
  const std::vector<Statement> told = verdict::effect_findings(c);
  ASSERT_EQ(told.size(), 2U) << "neither the one in doubt nor the one that nobody asks of";
  EXPECT_NE(as_code(told[0]).find("effect.offset"), std::string::npos) << as_code(told[0]);
  EXPECT_NE(as_code(told[1]).find("effect.load"), std::string::npos) << as_code(told[1]);
  const std::optional<verdict::Measured> load =
      verdict::measure_effect(c, "load", c.model.friction_Nm);
  ASSERT_TRUE(load);
  EXPECT_NEAR(load->value, 5, 1e-9);
  EXPECT_EQ(load->finding, told[1]) << "said in the same words, and so once";
  EXPECT_EQ(verdict::measure_effect(c, "position", 4)->value, 0);
  EXPECT_FALSE(verdict::measure_effect(c, "lag", 4));
}

}  // namespace
}  // namespace tribolog::model_verdict_test
