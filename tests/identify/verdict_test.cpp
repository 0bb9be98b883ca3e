// The verdict on each quantity, and the manifest's limits.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>

#include "base/requirements.h"
#include "identify/identify.h"
#include "support/paper_joint.h"
#include "verdict/acceptance.h"
#include "wording/words.h"

namespace tribolog::verdict_test {
namespace {

using method::checks::CheckName;

const calibration::QuantityVerdict& quantity(const calibration::Calibration& c,
                                             joint::Quantity quantity) {
  const calibration::QuantityVerdict* found = c.judgement.find(quantity);
  if (found == nullptr) throw std::logic_error("no quantity " + to_string(quantity));
  return *found;
}

/// A quantity of 10 N·m at the motor, between 9 and 11.
std::vector<calibration::QuantityVerdict> ten_Nm() {
  calibration::QuantityVerdict q;
  q.quantity = joint::Quantity::coulomb_torque;
  q.estimate = statistics::Estimate{10, 9, 11, {}};
  q.unit = "N·m";
  return {q};
}

calibration::LimitState state_of(joint::AcceptanceLimit limit, double gear_ratio = 1) {
  auto quantities = ten_Nm();
  verdict::apply_limits({limit}, gear_ratio, quantities);
  EXPECT_EQ(quantities[0].limits.size(), 1U);
  EXPECT_EQ(quantities[0].verdict == calibration::Verdict::usable,
            quantities[0].limits[0].state == calibration::LimitState::inside);
  return quantities[0].limits[0].state;
}

joint::AcceptanceLimit with_max(double max, const std::string& key = "coulomb_motor_Nm") {
  joint::AcceptanceLimit limit;
  limit.quantity = key;
  limit.max = max;
  return limit;
}

TEST(AcceptanceLimits, LookAtTheWholeInterval) {
  EXPECT_EQ(state_of(with_max(11)), calibration::LimitState::inside);
  EXPECT_EQ(state_of(with_max(10.5)), calibration::LimitState::crosses);
  EXPECT_EQ(state_of(with_max(9.5)), calibration::LimitState::crosses);
  EXPECT_EQ(state_of(with_max(8.9)), calibration::LimitState::outside);
  joint::AcceptanceLimit least;
  least.quantity = "coulomb_motor_Nm";
  least.min = 9;
  EXPECT_EQ(state_of(least), calibration::LimitState::inside);
  least.min = 10.5;
  EXPECT_EQ(state_of(least), calibration::LimitState::crosses);
  least.min = 12;
  EXPECT_EQ(state_of(least), calibration::LimitState::outside);
}

TEST(AcceptanceLimits, AreCarriedToTheirSideOfTheGear) {
  EXPECT_EQ(state_of(with_max(1101, "coulomb_joint_Nm"), 100), calibration::LimitState::inside);
  EXPECT_EQ(state_of(with_max(899, "coulomb_joint_Nm"), 100), calibration::LimitState::outside);
}

TEST(AcceptanceLimits, BoundTheWidthOfTheInterval) {
  joint::AcceptanceLimit width;
  width.quantity = "coulomb_joint_Nm";
  width.half_width_percent = 10.5;
  EXPECT_EQ(state_of(width, 50),
            calibration::LimitState::inside);  // ±10 % on either side of the gear
  width.half_width_percent = 9.5;
  EXPECT_EQ(state_of(width, 50), calibration::LimitState::outside);
  width.half_width_percent.reset();
  width.half_width = 49;
  EXPECT_EQ(state_of(width, 50), calibration::LimitState::outside);
  width.half_width = 51;
  EXPECT_EQ(state_of(width, 50), calibration::LimitState::inside);
}

TEST(AcceptanceLimits, OfWhatIsNotKnownAreNotKept) {
  auto quantities = ten_Nm();
  quantities[0].estimate.reset();
  verdict::apply_limits({with_max(100)}, 1, quantities);
  EXPECT_EQ(quantities[0].limits[0].state, calibration::LimitState::unknown);
  EXPECT_EQ(quantities[0].verdict, calibration::Verdict::doubtful);
}

TEST(Verdicts, TheNoiseFreeJointIsUsableInEveryQuantityThatDecides) {
  const joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  const calibration::Calibration c = identify::identify(d);
  ASSERT_EQ(c.judgement.quantities.size(), 11U);
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    // Eq. (6), which this joint follows, has neither a Coulomb torque nor one viscous coefficient.
    if (q.quantity == joint::Quantity::coulomb_torque ||
        q.quantity == joint::Quantity::viscous_coefficient) {
      EXPECT_NE(q.verdict, calibration::Verdict::usable);
      EXPECT_FALSE(q.decides);
      continue;
    }
    EXPECT_EQ(q.verdict, calibration::Verdict::usable)
        << to_string(q.quantity) << ": " << wording::words(q.reasons.front());
  }
  EXPECT_EQ(c.judgement.verdict, calibration::Verdict::usable);
}

TEST(Verdicts, ABrokenLimitMakesAUsableJointDoubtful) {
  joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  d.manifest.limits = {with_max(70, "surrogate_mass_kg")};
  const calibration::Calibration c = identify::identify(d);
  EXPECT_EQ(c.judgement.verdict, calibration::Verdict::doubtful);
  EXPECT_EQ(quantity(c, joint::Quantity::surrogate_mass).verdict, calibration::Verdict::doubtful);
  EXPECT_EQ(quantity(c, joint::Quantity::gravity_torque).verdict, calibration::Verdict::usable);
  EXPECT_NE(wording::words(c.judgement.findings.front()).find("does not meet the limit"),
            std::string::npos)
      << wording::words(c.judgement.findings.front());
  d.manifest.limits = {with_max(80, "surrogate_mass_kg")};
  EXPECT_EQ(identify::identify(d).judgement.verdict, calibration::Verdict::usable);
}

TEST(Verdicts, TheFirstScreenSaysWhichNumbersAreDoubtfulAndWhyBeforeAllElse) {
  const joint::Dataset d = simulate::simulated_dataset([] {
    simulate::Scenario s = test::paper_joint();
    s.effects.friction_by_angle = 0.05;
    return s;
  }());
  const calibration::Calibration c = identify::identify(d);
  ASSERT_EQ(c.judgement.sentence.code().text(), "verdict.not_all_usable");
  const std::string sentence = wording::words(c.judgement.sentence);
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    const std::string name =
        wording::words(Statement(Code::of("quantity." + to_string(q.quantity))));
    const bool is_named = sentence.find(name) != std::string::npos;
    EXPECT_EQ(is_named, q.decides && q.verdict != calibration::Verdict::usable) << name;
    if (is_named) {
      EXPECT_NE(std::find(c.judgement.findings.begin(), c.judgement.findings.begin() + 3,
                          q.reasons.front()),
                c.judgement.findings.begin() + 3)
          << name << ": " << wording::words(q.reasons.front());
    }
  }
}

TEST(Verdicts, OneDirectionLeavesCoulombAndOffsetInseparable) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep->both_directions = false;
  s.constant_speed->both_directions = false;
  const joint::Dataset d = simulate::simulated_dataset(s);
  const calibration::Calibration c = identify::identify(d);
  const calibration::QuantityVerdict& coulomb = quantity(c, joint::Quantity::coulomb_torque);
  EXPECT_EQ(coulomb.verdict, calibration::Verdict::not_identifiable);
  // Besides, its law has none.
  EXPECT_TRUE(std::any_of(coulomb.reasons.begin(), coulomb.reasons.end(), [](const auto& reason) {
    return wording::words(reason).find("Coulomb friction and offset cannot be told apart") !=
           std::string::npos;
  }));
  // The loop goes both ways, so its gravity is as good as ever.
  EXPECT_EQ(quantity(c, joint::Quantity::bristle_stiffness).verdict, calibration::Verdict::usable);
}

TEST(Verdicts, WithoutTorqueNothingThatNeedsItIsIdentifiable) {
  joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  d.manifest.drive = joint::Drive(100, joint::EffortKind::none, joint::Side::motor);
  for (joint::Recording& r : d.recordings) r.torque_Nm.clear();
  const calibration::Calibration c = identify::identify(d);
  EXPECT_EQ(c.judgement.verdict, calibration::Verdict::not_identifiable);
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    EXPECT_EQ(q.verdict, calibration::Verdict::not_identifiable) << to_string(q.quantity);
    EXPECT_NE(wording::words(q.reasons.front()).find("no torque was recorded"), std::string::npos)
        << to_string(q.quantity);
    EXPECT_FALSE(q.experiment.empty()) << to_string(q.quantity);
  }
  // What the motion says is still said.
  EXPECT_EQ(c.data_checks.find(CheckName::speed_scale)->state, method::checks::CheckState::passed);
  EXPECT_EQ(c.data_checks.find(CheckName::run_common_angles)->state,
            method::checks::CheckState::passed);
  EXPECT_EQ(c.data_checks.find(CheckName::torque_noise)->state,
            method::checks::CheckState::not_applicable);
}

// Nothing but a loop hundreds of times as wide as the bristle bends. The drive jumps to its speed
// at once, and the first sample holds four times the torque of the loop.
calibration::Calibration of_wide_loop_alone(double amplitude_rad) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.constant_speed.reset();
  s.oscillation->amplitude_rad = amplitude_rad;
  s.oscillation->record_bristle = false;
  return identify::identify(test::simulated_dataset(s));
}

TEST(Verdicts, AModelThatMissesAWideLoopGivesNoUsableBreakAwayTorque) {
  const calibration::QuantityVerdict q =
      quantity(of_wide_loop_alone(0.03), joint::Quantity::break_away_torque);
  const double truth = test::paper_contact().parameters().static_Nm;
  if (!q.estimate || std::abs(q.estimate->value / truth - 1) < 0.02) return;
  EXPECT_NE(q.verdict, calibration::Verdict::usable) << q.estimate->value;
}

TEST(Verdicts, AWideLoopReachesSliding) {
  const calibration::Calibration c = of_wide_loop_alone(0.01);
  EXPECT_EQ(c.data_checks.find(CheckName::oscillation_slides)->state,
            method::checks::CheckState::passed);
  const calibration::QuantityVerdict q = quantity(c, joint::Quantity::break_away_torque);
  EXPECT_EQ(q.verdict, calibration::Verdict::usable);
  EXPECT_NEAR(present(q.estimate).value, test::paper_contact().parameters().static_Nm, 1e-3);
}

}  // namespace
}  // namespace tribolog::verdict_test
