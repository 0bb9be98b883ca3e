// What each quantity hangs on: the sensitivities of its budget against the quantity itself, found
// once more with one influence changed.

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "identify/influence_shifts.h"
#include "support/paper_joint.h"
#include "verdict/judge.h"

namespace tribolog::uncertainty_budget_test {
namespace {

using calibration::BudgetPart;
using calibration::Influence;
using joint::Dataset;
using joint::Quantity;

constexpr double percent = 1;

Dataset stated(Dataset d) {
  d.manifest.uncertainty = {percent, percent, percent, percent, 0.1, {}};
  return d;
}

calibration::Calibration identified(const Dataset& d) {
  identify::IdentifyOptions options;
  options.truth_runs = 0;
  return identify::identify(d, options);
}

const BudgetPart* part_of(const calibration::QuantityVerdict& q, Influence influence) {
  for (const BudgetPart& part : q.budget->parts) {
    if (part.influence == influence) return &part;
  }
  return nullptr;
}

/// d ln(quantity) / d ln(influence) against the sensitivity that the budget states.
void expect_sensitivities(Influence influence,
                          const std::function<void(Dataset&, double)>& change) {
  Dataset d = stated(simulate::simulated_dataset(test::noisy_paper_joint(4)));
  const calibration::Calibration before = identified(d);
  constexpr double factor = 1.01;
  change(d, factor);
  const calibration::Calibration after = identified(d);
  std::size_t compared = 0;
  for (const calibration::QuantityVerdict& q : before.judgement.quantities) {
    // Cells are whole turns of the motor: of another gear ratio, others, and laws that disagree at
    // the ends of the curve then weigh otherwise.
    const bool hangs_on_cells =
        influence == Influence::gear_ratio &&
        (q.quantity == Quantity::coulomb_torque || q.quantity == Quantity::stribeck_speed ||
         q.quantity == Quantity::viscous_coefficient);
    if (hangs_on_cells || !q.estimate || q.quantity == Quantity::cog_angle) continue;
    const auto* changed = after.judgement.find(q.quantity);
    ASSERT_TRUE(changed != nullptr && changed->estimate) << to_string(q.quantity);
    const double exponent =
        std::log(changed->estimate->value / q.estimate->value) / std::log(factor);
    const BudgetPart* part = part_of(q, influence);
    constexpr double of_other_cells = 0.1;
    EXPECT_NEAR(exponent, part == nullptr ? 0 : part->sensitivity, of_other_cells)
        << to_string(q.quantity);
    ++compared;
  }
  EXPECT_GE(compared, influence == Influence::gear_ratio ? 5U : 8U);
}

TEST(Budget, TorquesAreInProportionToTheTorqueConstant) {
  expect_sensitivities(Influence::torque_constant, [](Dataset& d, double factor) {
    for (joint::Recording& r : d.recordings) {
      for (double& torque : r.torque_Nm) torque *= factor;
    }
  });
}

TEST(Budget, HangsOnTheGearRatioAsTheSidesOfTheLogSay) {
  expect_sensitivities(Influence::gear_ratio, [](Dataset& d, double factor) {
    d.manifest.drive = joint::Drive(factor * d.manifest.drive.gear_ratio(),
                                    joint::EffortKind::motor_torque, joint::Side::motor);
  });
}

TEST(Budget, OnlyTheMassHangsOnDistanceAndGravity) {
  expect_sensitivities(Influence::surrogate_distance, [](Dataset& d, double factor) {
    d.manifest.surrogate_distance_m *= factor;
  });
  expect_sensitivities(Influence::gravity,
                       [](Dataset& d, double factor) { d.manifest.gravity_m_s2 *= factor; });
}

/// A wrong constant of which the manifest knows is inside of every expanded interval.
TEST(Budget, HoldsTheTruthBesideAWrongTorqueConstant) {
  Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  const calibration::Calibration right = identified(d);
  d.manifest.uncertainty.torque_constant_percent = 2;
  for (joint::Recording& r : d.recordings) {
    for (double& torque : r.torque_Nm) torque *= 1.018;
  }
  const calibration::Calibration wrong = identified(d);
  for (const Quantity quantity : {Quantity::gravity_torque, Quantity::surrogate_mass,
                                  Quantity::break_away_torque, Quantity::bristle_stiffness}) {
    const double truth = right.judgement.find(quantity)->estimate->value;
    const calibration::QuantityVerdict& q = *wrong.judgement.find(quantity);
    ASSERT_TRUE(q.budget) << to_string(quantity);
    EXPECT_LE(q.budget->expanded.low, truth) << to_string(quantity);
    EXPECT_GE(q.budget->expanded.high, truth) << to_string(quantity);
  }
  const calibration::QuantityVerdict& mass = *wrong.judgement.find(Quantity::surrogate_mass);
  EXPECT_GT(mass.estimate->low, right.judgement.find(Quantity::surrogate_mass)->estimate->value);
  EXPECT_NEAR(mass.budget->expanded.half_width() / mass.estimate->value, 0.02, 0.0005);
}

/// A hose that over the sweep's part of a turn looks like gravity: what the manifest states of it
/// is in the intervals.
TEST(Budget, HoldsTheTruthBesideAHoseThatLooksLikeGravity) {
  Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  d.manifest.effects = {};  // as of a joint that nobody simulated
  const calibration::Calibration right = identified(d);
  const double spring_Nm =
      0.002 * std::abs(right.judgement.find(Quantity::gravity_torque)->estimate->value);
  for (joint::Recording& r : d.recordings) {
    for (std::size_t i = 0; i < r.torque_Nm.size(); ++i) r.torque_Nm[i] += spring_Nm * r.q_rad[i];
  }
  const calibration::Calibration unstated = identified(d);
  d.manifest.uncertainty.hoses_percent = 0.2;
  const calibration::Calibration with_hose = identified(d);
  for (const Quantity quantity :
       {Quantity::cog_angle, Quantity::gravity_torque, Quantity::surrogate_mass}) {
    const double truth = right.judgement.find(quantity)->estimate->value;
    const calibration::QuantityVerdict& q = *with_hose.judgement.find(quantity);
    ASSERT_TRUE(q.budget) << to_string(quantity);
    EXPECT_LE(q.budget->expanded.low, truth) << to_string(quantity);
    EXPECT_GE(q.budget->expanded.high, truth) << to_string(quantity);
    EXPECT_NE(part_of(q, Influence::hoses), nullptr) << to_string(quantity);
    // Where nothing is stated typical ones are in the model's interval.
    const auto& missing = unstated.judgement.find(quantity)->budget->not_stated;
    EXPECT_EQ(std::find(missing.begin(), missing.end(), Influence::hoses), missing.end());
  }
  const auto half_width_of_angle = [](const calibration::Calibration& c) {
    return c.judgement.find(Quantity::cog_angle)->budget->expanded.half_width();
  };
  EXPECT_GT(half_width_of_angle(with_hose), half_width_of_angle(unstated));
}

/// What a stated influence makes unfindable is in no interval: the quantity is doubted, and why is
/// told.
TEST(Budget, DoubtsWhatAStatedInfluenceHides) {
  calibration::Calibration c = identified(simulate::simulated_dataset(test::noisy_paper_joint(7)));
  ASSERT_EQ(c.judgement.find(Quantity::cog_angle)->verdict, calibration::Verdict::usable);
  c.influence_shifts.push_back({Influence::hoses, Quantity::cog_angle, std::nullopt});
  const calibration::Judgement doubted = verdict::judge(c);
  const calibration::QuantityVerdict& angle = *doubted.find(Quantity::cog_angle);
  EXPECT_EQ(angle.verdict, calibration::Verdict::doubtful);
  ASSERT_FALSE(angle.reasons.empty());
  EXPECT_TRUE(angle.reasons.front().is("cause.hidden_by_hoses"));
  EXPECT_EQ(doubted.find(Quantity::gravity_torque)->verdict, calibration::Verdict::usable);
}

/// The larger change of both sides is kept; what is lost at one side is kept as lost.
TEST(Budget, KeepsTheLargerShiftAndWhatIsLost) {
  Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  d.manifest.uncertainty.hoses_percent = 1;
  const auto quantity = [](Quantity name, double value) {
    calibration::QuantityVerdict q;
    q.quantity = name;
    q.estimate = statistics::symmetric_estimate(value, 0, {});
    return q;
  };
  calibration::Judgement stated;
  stated.quantities = {quantity(Quantity::gravity_torque, 2), quantity(Quantity::cog_angle, 1),
                       quantity(Quantity::inertia, 3)};
  int calls = 0;
  const auto shifts = identify::find_influence_shifts(d, stated, [&](const Dataset& /*shifted*/) {
    std::vector<calibration::QuantityVerdict> found = stated.quantities;
    const bool is_first = calls++ == 0;
    found[0].estimate = statistics::symmetric_estimate(is_first ? 2.25 : 1.5, 0, {});
    if (!is_first) found[1].estimate.reset();
    return found;
  });
  ASSERT_EQ(calls, 2);
  ASSERT_EQ(shifts.size(), 2U);
  EXPECT_EQ(shifts[0].quantity, Quantity::gravity_torque);
  EXPECT_EQ(shifts[0].half_width, 0.5);
  EXPECT_EQ(shifts[1].quantity, Quantity::cog_angle);
  EXPECT_FALSE(shifts[1].half_width);
}

TEST(Budget, SaysWhereAnErrorComesFrom) {
  Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  d.manifest.uncertainty.torque_constant_percent = 2;
  d.manifest.uncertainty.gravity_percent = 0.1;
  const auto id_of = [&](Influence influence) {
    return part_of(*identified(d).judgement.find(Quantity::surrogate_mass), influence)->id;
  };
  EXPECT_EQ(id_of(Influence::gravity), "9.81 m/s²");
  const std::string by_joint = id_of(Influence::torque_constant);
  EXPECT_NE(by_joint.find(d.manifest.serial), std::string::npos) << by_joint;
  d.manifest.uncertainty.id["torque_constant"] = "stand 3";
  EXPECT_EQ(id_of(Influence::torque_constant), "stand 3");
}

TEST(Budget, SaysThatNobodyStatedTheTorqueConstant) {
  Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  const auto told = [](const calibration::Calibration& c) {
    for (const Statement& finding : c.judgement.findings) {
      if (std::string(finding.code().text()).starts_with("budget.torque")) return true;
    }
    return false;
  };
  EXPECT_TRUE(told(identified(d)));
  d.manifest.uncertainty.torque_constant_percent = 0;
  EXPECT_FALSE(told(identified(d)));
}

/// A limit that the recordings alone would keep is not shown to be kept by a vague torque constant.
TEST(Budget, DecidesTheManifestsLimits) {
  Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  joint::AcceptanceLimit limit;
  limit.quantity = "surrogate_mass_kg";
  limit.half_width_percent = 1;
  d.manifest.limits = {limit};
  const auto state = [&] {
    return identified(d).judgement.find(Quantity::surrogate_mass)->limits.front().state;
  };
  EXPECT_EQ(state(), calibration::LimitState::inside);
  d.manifest.uncertainty.torque_constant_percent = 2;
  EXPECT_EQ(state(), calibration::LimitState::outside);
}

TEST(UncertaintyBudget, TellsWhichEffectsWouldNarrowANumberIfTheirSizesWereKnown) {
  Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(4));
  const auto half_width = [](const calibration::Calibration& c) {
    return c.judgement.find(Quantity::gravity_torque)->estimate->half_width();
  };
  d.manifest.effects = {};
  const calibration::Calibration unstated = identified(d);
  const auto& effects = unstated.judgement.find(Quantity::gravity_torque)->budget->effects;
  ASSERT_FALSE(effects.empty());
  double before = 2;
  for (const calibration::BudgetEffect& one : effects) {
    EXPECT_LE(one.share, before) << one.effect;
    EXPECT_FALSE(one.is_stated) << one.effect;
    before = one.share;
  }
  // An effect that is stated as absent is no part any more, and the interval is narrower.
  const auto has = [](const calibration::Calibration& c, std::string_view effect) {
    const auto& all = c.judgement.find(Quantity::gravity_torque)->budget->effects;
    return std::any_of(all.begin(), all.end(),
                       [&](const auto& one) { return one.effect == effect; });
  };
  EXPECT_TRUE(has(unstated, joint::effect::offset.key));
  // What the directions of friction do not share is an offset too.
  d.manifest.effects.state(joint::effect::offset, 0);
  d.manifest.effects.state(joint::effect::asymmetry, 0);
  const calibration::Calibration stated = identified(d);
  EXPECT_FALSE(has(stated, joint::effect::offset.key));
  EXPECT_LT(half_width(stated), half_width(unstated));
}

}  // namespace
}  // namespace tribolog::uncertainty_budget_test
