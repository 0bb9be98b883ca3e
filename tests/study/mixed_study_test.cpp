// The study of joints drawn at random, with many small effects at once.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "friction/lugre.h"
#include "simulate/simulate_joint.h"
#include "study/misfit.h"
#include "study/misfit_truths.h"
#include "study/mixed_joints.h"

namespace tribolog::mixed_study_test {
namespace {

using joint::Quantity;

const study::MisfitQuantity& quantity(const study::MisfitCase& c, Quantity which) {
  return *std::find_if(c.quantities.begin(), c.quantities.end(),
                       [&](const study::MisfitQuantity& q) { return q.quantity == which; });
}

TEST(MixedJoints, AreAnotherEachAndTheSameAgain) {
  const study::MixedJoint first = study::mixed_joint(1, 0, 1);
  const study::MixedJoint again = study::mixed_joint(1, 0, 1);
  const study::MixedJoint later = study::mixed_joint(1, 12, 1);  // about the same of the twelve
  EXPECT_EQ(first.laid.load.q_peak_rad(), again.laid.load.q_peak_rad());
  EXPECT_EQ(first.laid.effects.warm_up, again.laid.effects.warm_up);
  EXPECT_NE(first.laid.load.q_peak_rad(), later.laid.load.q_peak_rad());
  EXPECT_NE(first.laid.gear_ratio, later.laid.gear_ratio);
  EXPECT_NE(first.laid.effects.warm_up, later.laid.effects.warm_up);
}

TEST(MixedJoints, HaveAllEffectsByTheirSizeAndStateNone) {
  const study::MixedJoint once = study::mixed_joint(7, 3, 1);
  const study::MixedJoint twice = study::mixed_joint(7, 3, 2);
  EXPECT_FALSE(once.undisturbed.effects.any());
  EXPECT_FALSE(simulate::absent_effects(once.undisturbed).stated().empty());
  EXPECT_TRUE(simulate::absent_effects(once.laid).stated().empty());
  const auto sizes = [](const simulate::Scenario& s) {
    const simulate::JointEffects& e = s.effects;
    const simulate::LogEffects& log = s.noise.effects;
    return std::vector<double>{
        e.direction_asymmetry,  e.load_friction,           e.warm_up,
        e.torque_offset_Nm,     e.spring_Nm_rad,           e.twice_the_angle_Nm,
        e.friction_by_angle,    e.friction_by_motor_angle, log.torque_delay_s,
        log.saturation_per_Nm2, e.offset_drift_Nm,         e.viscous_exponent - 1,
        log.coloured_Nm,        log.scale_of_runs - 1};
  };
  const std::vector<double> small = sizes(once.laid);
  const std::vector<double> large = sizes(twice.laid);
  for (std::size_t k = 0; k < small.size(); ++k) {
    EXPECT_NE(small[k], 0) << k;
    EXPECT_NEAR(large[k], 2 * small[k], 1e-12) << k;
  }
}

TEST(MisfitTruths, AreThoseAtTheMeanOfTheRuns) {
  const simulate::Scenario plain = study::misfit_joints().front().scenario;
  simulate::Scenario laid = plain;
  laid.effects.warm_up = 0.2;
  laid.effects.load_friction = 0.1;
  laid.effects.friction_by_motor_angle = 0.3;
  const auto truths = study::truths_of(plain, laid, simulate::simulate_ideal_joint(laid));
  const auto before = study::truths_of(plain, plain, simulate::simulate_ideal_joint(plain));
  const double of_load = 0.1 * laid.load.amplitude_Nm() / laid.gear_ratio;
  const double cold = before.at(Quantity::coulomb_torque);
  EXPECT_DOUBLE_EQ(cold, 0.60);
  EXPECT_LT(truths.at(Quantity::coulomb_torque), 0.9 * cold + of_load);
  EXPECT_GT(truths.at(Quantity::coulomb_torque), 0.8 * cold + 0.8 * of_load);
  EXPECT_LT(truths.at(Quantity::viscous_coefficient),
            0.9 * before.at(Quantity::viscous_coefficient));
  // Not that of the ramps, which come when all is warm, and stand at the peak.
  const double kept =
      truths.at(Quantity::viscous_coefficient) / before.at(Quantity::viscous_coefficient);
  const double of_load_in_runs = truths.at(Quantity::coulomb_torque) - kept * cold;
  EXPECT_GT(kept, 0.8);
  EXPECT_LT(of_load_in_runs, of_load);
  EXPECT_NEAR(truths.at(Quantity::break_away_torque),
              kept * before.at(Quantity::break_away_torque) + of_load_in_runs, 1e-9);
  EXPECT_EQ(truths.at(Quantity::gravity_torque), before.at(Quantity::gravity_torque));
}

TEST(MisfitTruths, OfGravityAreWhatTheLogHas) {
  const simulate::Scenario plain = study::misfit_joints().front().scenario;
  simulate::Scenario laid = plain;
  laid.effects.gravity_left_out = 0.3;
  const auto ideal = simulate::simulate_ideal_joint(laid);
  const double whole = plain.load.amplitude_Nm() / plain.gear_ratio;
  EXPECT_DOUBLE_EQ(study::truths_of(plain, laid, ideal).at(Quantity::gravity_torque), 0.7 * whole);
  laid.effects.gravity_left_out = 1;
  EXPECT_TRUE(std::isnan(study::truths_of(plain, laid, ideal).at(Quantity::cog_angle)));
}

TEST(MixedStudy, CountsEachJointAgainstATruthOfItsOwn) {
  study::MixedOptions options;
  options.joints = 3;
  const std::vector<study::MisfitCase> cases = study::run_mixed_study(options);
  ASSERT_EQ(cases.size(), 2U);
  for (const study::MisfitCase& c : cases) {
    EXPECT_EQ(c.runs, 3U);
    EXPECT_FALSE(c.has_cause);
    for (const Quantity which : {Quantity::gravity_torque, Quantity::cog_angle,
                                 Quantity::coulomb_torque, Quantity::inertia}) {
      const study::MisfitQuantity& q = quantity(c, which);
      EXPECT_TRUE(std::isnan(q.truth)) << to_string(which);
      EXPECT_EQ(q.found, 3U) << to_string(which);
      EXPECT_EQ(q.judged, 3U) << to_string(which);
      EXPECT_LE(q.inside + q.wrong, q.judged) << to_string(which);
      EXPECT_LE(q.wrong_usable, q.wrong) << to_string(which);
    }
    // Another joint's truth would be off by tens of percent; without effects errors are no larger
    // than noise.
    EXPECT_GE(quantity(c, Quantity::gravity_torque).inside, 2U);
    EXPECT_LT(quantity(c, Quantity::gravity_torque).rms_error, 50);
    EXPECT_GT(quantity(c, Quantity::gravity_torque).rms_error, 0.5);
    EXPECT_LT(quantity(c, Quantity::coulomb_torque).rms_error, 5);
  }
}

TEST(MixedStudy, IsTheSameOnAnyNumberOfThreads) {
  study::MixedOptions options;
  options.joints = 2;
  options.threads = 1;
  const auto one = study::run_mixed_study(options);
  options.threads = 2;
  const auto two = study::run_mixed_study(options);
  for (std::size_t k = 0; k < one.size(); ++k) {
    for (const study::MisfitQuantity& q : one[k].quantities) {
      EXPECT_EQ(q.rms_error, quantity(two[k], q.quantity).rms_error) << to_string(q.quantity);
    }
  }
}

}  // namespace
}  // namespace tribolog::mixed_study_test
