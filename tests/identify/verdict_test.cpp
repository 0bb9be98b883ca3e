// The verdict on each quantity, and the manifest's limits.

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "support/paper_joint.h"
#include "verdict/acceptance.h"

namespace tribolog {
namespace {

const QuantityVerdict& quantity(const Calibration& c, std::string_view key) {
  const auto& all = c.judgement.quantities;
  const auto it =
      std::find_if(all.begin(), all.end(), [&](const QuantityVerdict& q) { return q.key == key; });
  if (it == all.end()) throw std::logic_error("no quantity " + std::string(key));
  return *it;
}

/// A quantity of 10 N·m at the motor, between 9 and 11.
std::vector<QuantityVerdict> ten_Nm() {
  QuantityVerdict q;
  q.key = "coulomb_torque";
  q.words = "Coulomb torque";
  q.estimate = Estimate{10, 9, 11, "stated"};
  q.unit = "N·m";
  return {q};
}

LimitState state_of(AcceptanceLimit limit, double gear_ratio = 1) {
  auto quantities = ten_Nm();
  apply_limits({limit}, gear_ratio, quantities);
  EXPECT_EQ(quantities[0].limits.size(), 1U);
  EXPECT_EQ(quantities[0].verdict == Verdict::usable,
            quantities[0].limits[0].state == LimitState::inside);
  return quantities[0].limits[0].state;
}

AcceptanceLimit with_max(double max, const std::string& key = "coulomb_motor_Nm") {
  AcceptanceLimit limit;
  limit.quantity = key;
  limit.max = max;
  return limit;
}

TEST(AcceptanceLimits, LookAtTheWholeInterval) {
  EXPECT_EQ(state_of(with_max(11)), LimitState::inside);
  EXPECT_EQ(state_of(with_max(10.5)), LimitState::crosses);
  EXPECT_EQ(state_of(with_max(9.5)), LimitState::crosses);
  EXPECT_EQ(state_of(with_max(8.9)), LimitState::outside);
  AcceptanceLimit least;
  least.quantity = "coulomb_motor_Nm";
  least.min = 9;
  EXPECT_EQ(state_of(least), LimitState::inside);
  least.min = 10.5;
  EXPECT_EQ(state_of(least), LimitState::crosses);
  least.min = 12;
  EXPECT_EQ(state_of(least), LimitState::outside);
}

TEST(AcceptanceLimits, AreCarriedToTheirSideOfTheGear) {
  EXPECT_EQ(state_of(with_max(1101, "coulomb_joint_Nm"), 100), LimitState::inside);
  EXPECT_EQ(state_of(with_max(899, "coulomb_joint_Nm"), 100), LimitState::outside);
}

TEST(AcceptanceLimits, BoundTheWidthOfTheInterval) {
  AcceptanceLimit width;
  width.quantity = "coulomb_joint_Nm";
  width.half_width_percent = 10.5;
  EXPECT_EQ(state_of(width, 50), LimitState::inside);  // ±10 % on either side of the gear
  width.half_width_percent = 9.5;
  EXPECT_EQ(state_of(width, 50), LimitState::outside);
  width.half_width_percent.reset();
  width.half_width = 49;
  EXPECT_EQ(state_of(width, 50), LimitState::outside);
  width.half_width = 51;
  EXPECT_EQ(state_of(width, 50), LimitState::inside);
}

TEST(AcceptanceLimits, OfWhatIsNotKnownAreNotKept) {
  auto quantities = ten_Nm();
  quantities[0].estimate.reset();
  apply_limits({with_max(100)}, 1, quantities);
  EXPECT_EQ(quantities[0].limits[0].state, LimitState::unknown);
  EXPECT_EQ(quantities[0].verdict, Verdict::doubtful);
}

TEST(Verdicts, TheNoiseFreeJointIsUsableInEveryQuantityThatDecides) {
  const Dataset d = simulated_dataset(test::paper_joint());
  const Calibration c = identify(d);
  ASSERT_EQ(c.judgement.quantities.size(), 11U);
  for (const QuantityVerdict& q : c.judgement.quantities) {
    if (q.key == "inertia") {  // 0.0001 N·m in a slow loop: it is said to be missing, not guessed
      EXPECT_EQ(q.verdict, Verdict::not_identifiable);
      EXPECT_FALSE(q.experiment.empty());
      continue;
    }
    EXPECT_EQ(q.verdict, Verdict::usable) << q.key << ": " << q.reasons.front();
  }
  EXPECT_EQ(c.judgement.verdict, Verdict::usable);
}

TEST(Verdicts, ABrokenLimitMakesAUsableJointDoubtful) {
  Dataset d = simulated_dataset(test::paper_joint());
  d.manifest.limits = {with_max(70, "surrogate_mass_kg")};
  const Calibration c = identify(d);
  EXPECT_EQ(c.judgement.verdict, Verdict::doubtful);
  EXPECT_EQ(quantity(c, "surrogate_mass").verdict, Verdict::doubtful);
  EXPECT_EQ(quantity(c, "gravity_torque").verdict, Verdict::usable);
  EXPECT_NE(c.judgement.findings.front().find("breaks the limit"), std::string::npos)
      << c.judgement.findings.front();
  d.manifest.limits = {with_max(80, "surrogate_mass_kg")};
  EXPECT_EQ(identify(d).judgement.verdict, Verdict::usable);
}

TEST(Verdicts, OneDirectionLeavesCoulombAndOffsetInseparable) {
  Scenario s = test::paper_joint();
  s.rough_sweep->both_directions = false;
  s.constant_speed->both_directions = false;
  const Dataset d = simulated_dataset(s);
  const Calibration c = identify(d);
  const QuantityVerdict& coulomb = quantity(c, "coulomb_torque");
  EXPECT_EQ(coulomb.verdict, Verdict::not_identifiable);
  EXPECT_NE(coulomb.reasons.front().find("Coulomb friction and offset cannot be told apart"),
            std::string::npos)
      << coulomb.reasons.front();
  // The loop goes both ways, so its gravity is as good as ever.
  EXPECT_EQ(quantity(c, "bristle_stiffness").verdict, Verdict::usable);
}

TEST(Verdicts, WithoutTorqueNothingThatNeedsItIsIdentifiable) {
  Dataset d = simulated_dataset(test::paper_joint());
  d.manifest.drive = Drive(100, EffortKind::none, Side::motor);
  for (Recording& r : d.recordings) r.torque_Nm.clear();
  const Calibration c = identify(d);
  EXPECT_EQ(c.judgement.verdict, Verdict::not_identifiable);
  for (const QuantityVerdict& q : c.judgement.quantities) {
    EXPECT_EQ(q.verdict, Verdict::not_identifiable) << q.key;
    EXPECT_NE(q.reasons.front().find("no torque was recorded"), std::string::npos) << q.key;
    EXPECT_FALSE(q.experiment.empty()) << q.key;
  }
  // What the motion says is still said.
  EXPECT_EQ(c.data_checks.find("speed_scale")->state, CheckState::passed);
  EXPECT_EQ(c.data_checks.find("run_common_angles")->state, CheckState::passed);
  EXPECT_EQ(c.data_checks.find("torque_noise")->state, CheckState::not_applicable);
}

}  // namespace
}  // namespace tribolog
