// The study of joints and logs that the method's model does not describe.

#include "study/misfit.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "simulate/simulate_joint.h"
#include "support/breadth.h"

namespace tribolog::misfit_test {
namespace {

const study::MisfitQuantity& quantity(const study::MisfitCase& c, joint::Quantity which) {
  return *std::find_if(c.quantities.begin(), c.quantities.end(),
                       [&](const study::MisfitQuantity& q) { return q.quantity == which; });
}

study::MisfitOptions on_the_arm(const std::string& disturbance) {
  study::MisfitOptions options;
  options.runs = 2;
  options.joints = {"geared_arm"};
  options.disturbances = {disturbance};
  return options;
}

/// Whose logs are a quarter as long.
study::MisfitOptions on_the_direct_drive(const std::string& disturbance) {
  study::MisfitOptions options = on_the_arm(disturbance);
  options.joints = {"direct_drive"};
  return options;
}

TEST(MisfitStudy, LaysThirtyDisturbancesInThreeSizesOnFourJoints) {
  EXPECT_GE(study::disturbances().size(), 30U);
  EXPECT_EQ(study::misfit_joints().size(), 12U);  // the last eight only when all is sound
  for (const study::Disturbance& d : study::disturbances()) {
    EXPECT_EQ(d.sizes.size(), 3U) << d.key;
    EXPECT_FALSE(d.named_by.empty()) << d.key;
  }
}

TEST(MisfitStudy, LaysWhatJointsHaveThatNoLawOfTheSpeedAloneDescribes) {
  const std::vector<study::Disturbance>& all = study::disturbances();
  for (const char* key : {"friction_by_motor_angle", "convex_viscous"}) {
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const auto& d) { return d.key == key; });
    ASSERT_NE(at, all.end()) << key;
    simulate::Scenario laid = study::misfit_joints().front().scenario;
    at->lay(laid, at->sizes.back());
    EXPECT_TRUE(laid.effects.any()) << key;
  }
}

TEST(MisfitStudy, LaysEachDisturbanceAtEachSize) {
  for (const study::MisfitJoint& joint : study::misfit_joints()) {
    for (const char* key :
         {"coulomb_model_added", "loop_torque_scale", "run_torque_scale", "uneven_gear_stiffness",
          "resonant_filter", "angle_crosstalk", "touch", "tool_changed", "held_messages",
          "foreign_recording", "gravity_left_out", "tare_between"}) {
      const auto& all = study::disturbances();
      const auto at =
          std::find_if(all.begin(), all.end(), [&](const auto& d) { return d.key == key; });
      ASSERT_NE(at, all.end()) << key;
      for (const double size : at->sizes) {
        simulate::Scenario laid = joint.scenario;
        at->lay(laid, size);
        EXPECT_TRUE(laid.effects.any() || laid.noise.effects.any()) << key << " " << size;
        EXPECT_TRUE(simulate::absent_effects(laid).stated().empty()) << key << " " << size;
      }
    }
  }
}

TEST(MisfitStudy, FrictionByTheMotorsAngleIsNamedAndNothingIsWrongAndUsable) {
  for (const study::MisfitCase& c :
       study::run_misfit_study(on_the_arm("friction_by_motor_angle"))) {
    for (const study::MisfitQuantity& q : c.quantities) {
      EXPECT_EQ(q.wrong_usable, 0U) << c.size << " " << to_string(q.quantity);
    }
    if (c.size > 0) {
      EXPECT_EQ(c.named, c.runs) << c.size;
    }
    // Loops and ramps stand at one angle of the motor.
    if (c.size <= 0.05) {
      EXPECT_GT(quantity(c, joint::Quantity::break_away_torque).usable, 0U) << c.size;
    }
  }
}

// A mean over more than starts and stops take is no lag any more: no finding names it as one.
TEST(MisfitStudy, AFilterOrAMeanOfTheTorqueLeavesNothingWrongAndUsable) {
  constexpr double longest_mean_s = 0.005;
  for (const char* key : {"torque_filter", "torque_mean"}) {
    for (const study::MisfitCase& c : study::run_misfit_study(on_the_direct_drive(key))) {
      for (const study::MisfitQuantity& q : c.quantities) {
        EXPECT_EQ(q.wrong_usable, 0U) << key << " " << c.size << " " << to_string(q.quantity);
      }
      const bool is_lag = std::string(key) == "torque_filter" || c.size <= longest_mean_s;
      if (c.size > 0 && is_lag) {
        EXPECT_EQ(c.named, c.runs) << key << " " << c.size;
      }
    }
  }
}

TEST(MisfitStudy, AConvexViscousTorqueLeavesCoulombTorqueAndStribeckVelocityRight) {
  TRIBOLOG_EACH_NIGHT();
  for (const study::MisfitCase& c : study::run_misfit_study(on_the_arm("convex_viscous"))) {
    for (const study::MisfitQuantity& q : c.quantities) {
      EXPECT_EQ(q.wrong_usable, 0U) << c.size << " " << to_string(q.quantity);
    }
    if (c.size > 0) {
      EXPECT_EQ(c.named, c.runs) << c.size;
    }
  }
}

TEST(MisfitStudy, ADipOfAnotherShapeIsNamedAndItsCurveIsKnown) {
  TRIBOLOG_EACH_NIGHT();
  for (const study::MisfitCase& c : study::run_misfit_study(on_the_arm("stribeck_power"))) {
    for (const study::MisfitQuantity& q : c.quantities) {
      EXPECT_EQ(q.wrong_usable, 0U) << c.size << " " << to_string(q.quantity);
    }
    for (const joint::Quantity which :
         {joint::Quantity::coulomb_torque, joint::Quantity::stribeck_speed,
          joint::Quantity::viscous_coefficient, joint::Quantity::bristle_stiffness}) {
      EXPECT_EQ(quantity(c, which).usable, c.runs) << c.size << " " << to_string(which);
    }
    if (c.size > 0) {
      EXPECT_EQ(c.named, c.runs) << c.size;
    }
  }
}

TEST(MisfitStudy, ABristleDampingThatFallsWithSpeedIsNotTakenForStiffness) {
  TRIBOLOG_EACH_NIGHT();
  for (const study::MisfitCase& c : study::run_misfit_study(on_the_arm("damping_fall"))) {
    for (const study::MisfitQuantity& q : c.quantities) {
      EXPECT_EQ(q.wrong_usable, 0U) << c.size << " " << to_string(q.quantity);
    }
  }
}

TEST(MisfitStudy, ATorqueOrAJumpOfTheAngleLeavesNothingWrongAndUsable) {
  std::size_t looked_at = 0;
  for (const char* const disturbance :
       test::some_of<const char*>({"spring", "angle_jumps", "homed_anew", "twice_the_angle",
                                   "torque_grows_out_of_proportion"},
                                  4)) {
    for (const study::MisfitCase& c : study::run_misfit_study(on_the_arm(disturbance))) {
      // Over part of a turn no more than this shows, and moves gravity by what matters.
      constexpr double most_hidden = 0.01;
      if (c.size > 0 && c.size <= most_hidden) continue;
      ++looked_at;
      for (const study::MisfitQuantity& q : c.quantities) {
        EXPECT_EQ(q.wrong_usable, 0U)
            << disturbance << " " << c.size << " " << to_string(q.quantity);
      }
    }
  }
  EXPECT_GT(looked_at, 0U);
}

// What shows as an offset of the torque may be a torque of twice the angle, which adds to gravity
// in the sweep and in the loops.
TEST(MisfitStudy, ATorqueThatPassesForAnOffsetIsInTheIntervalOfGravity) {
  for (const study::MisfitCase& c :
       study::run_misfit_study(on_the_direct_drive("twice_the_angle"))) {
    EXPECT_EQ(quantity(c, joint::Quantity::gravity_torque).wrong_usable, 0U) << c.size;
    EXPECT_EQ(quantity(c, joint::Quantity::surrogate_mass).wrong_usable, 0U) << c.size;
  }
}

// The offset it passes for may be little more than its own interval: many draws.
TEST(MisfitStudy, ATorqueThatPassesForASmallOffsetIsInTheIntervalOfGravity) {
  TRIBOLOG_EACH_NIGHT();
  study::MisfitOptions options = on_the_arm("twice_the_angle");
  options.joints = {"cobot_joint"};
  options.runs = 30;
  options.seed = 91;
  std::size_t looked_at = 0;
  for (const study::MisfitCase& c : study::run_misfit_study(options)) {
    constexpr double least_shown = 0.01;
    if (c.size < least_shown) continue;
    ++looked_at;
    EXPECT_EQ(quantity(c, joint::Quantity::gravity_torque).wrong_usable, 0U) << c.size;
    EXPECT_EQ(quantity(c, joint::Quantity::surrogate_mass).wrong_usable, 0U) << c.size;
  }
  EXPECT_GT(looked_at, 0U);
}

TEST(MisfitStudy, ATorqueOutOfProportionIsNamedAndNothingIsWrongAndUsable) {
  constexpr double smallest_named = 0.01;  // of the torque at the gravity peak
  for (const char* const disturbance :
       test::some_of<const char*>({"torque_saturates", "friction_taken_off"}, 2)) {
    for (const study::MisfitCase& c : study::run_misfit_study(on_the_direct_drive(disturbance))) {
      for (const study::MisfitQuantity& q : c.quantities) {
        EXPECT_EQ(q.wrong_usable, 0U)
            << disturbance << " " << c.size << " " << to_string(q.quantity);
      }
      if (c.size >= smallest_named) {
        EXPECT_EQ(c.named, c.runs) << disturbance << " " << c.size;
      }
    }
  }
}

// The joint is read where it accelerates already; starts and stops do not show by what inertia.
TEST(MisfitStudy, ACoarseEncoderLeavesTheBreakAwayTorqueRight) {
  for (const study::MisfitCase& c :
       study::run_misfit_study(on_the_direct_drive("coarse_encoder"))) {
    EXPECT_EQ(quantity(c, joint::Quantity::break_away_torque).wrong_usable, 0U) << c.size;
  }
}

// Its first fit takes more steps than that of white noise: it was given up for an elastic loop.
TEST(MisfitStudy, NoiseThatHangsTogetherLeavesTheStiffnessRight) {
  study::MisfitOptions options = on_the_arm("coloured_noise");
  options.joints = {"cobot_joint"};
  options.seed = 4001;
  const std::vector<study::MisfitCase> cases = study::run_misfit_study(options);
  const study::MisfitQuantity& found = quantity(cases.at(1), joint::Quantity::bristle_stiffness);
  // Where such noise hides how late the torque is, the stiffness is as wide as that says.
  EXPECT_GT(found.usable, 0U);
  EXPECT_EQ(found.wrong_usable, 0U);
}

TEST(MisfitStudy, OfASoundJointFindsWhatWasPutIn) {
  const auto cases = study::run_misfit_study(on_the_arm("torque_constant"));
  ASSERT_EQ(cases.size(), 4U);
  const study::MisfitCase& sound = cases.front();
  EXPECT_TRUE(sound.disturbance.empty());
  for (const joint::Quantity which : {joint::Quantity::cog_angle, joint::Quantity::gravity_torque,
                                      joint::Quantity::bristle_stiffness}) {
    const study::MisfitQuantity& q = quantity(sound, which);
    EXPECT_EQ(q.found, sound.runs) << to_string(which);
    EXPECT_EQ(q.wrong, 0U) << to_string(which);
  }
  // A torque constant that is off by half shows in no log: the number is wrong.
  const study::MisfitCase& off = cases.back();
  EXPECT_EQ(off.size, 1.5);
  EXPECT_EQ(quantity(off, joint::Quantity::gravity_torque).wrong, off.runs);
  EXPECT_EQ(quantity(off, joint::Quantity::cog_angle).wrong, 0U);
}

TEST(MisfitStudy, OfSoundJointsLaysNothingOnAnyOfThem) {
  study::MisfitOptions options;
  options.runs = test::seeds_of(1, 2);
  options.only_sound = true;
  const auto cases = study::run_misfit_study(options);
  ASSERT_EQ(cases.size(), 12U);
  for (const study::MisfitCase& c : cases) {
    EXPECT_TRUE(c.disturbance.empty()) << c.joint;
    const study::MisfitQuantity& gravity = quantity(c, joint::Quantity::gravity_torque);
    EXPECT_EQ(gravity.usable, c.runs) << c.joint;
    EXPECT_LT(gravity.worst_usable, 10) << c.joint;  // 1 %
  }
}

TEST(MisfitStudy, WhatIsNotStatedWidensTheIntervals) {
  study::MisfitOptions options;
  options.runs = test::seeds_of(1, 2);
  options.only_sound = true;
  options.joints = {"small_servo"};
  const auto stated = study::run_misfit_study(options);
  options.unstated = true;
  const auto unstated = study::run_misfit_study(options);
  for (const joint::Quantity which :
       {joint::Quantity::gravity_torque, joint::Quantity::coulomb_torque}) {
    const study::MisfitQuantity& wide = quantity(unstated.front(), which);
    EXPECT_GT(wide.half_width, 1.2 * quantity(stated.front(), which).half_width)
        << to_string(which);
    EXPECT_EQ(wide.inside, unstated.front().runs) << to_string(which);
  }
}

TEST(MisfitStudy, LessDataLeavesWhatIsAnsweredRight) {
  study::MisfitOptions options;
  options.runs = test::seeds_of(2, 10);
  options.lacks = true;
  options.joints = {"geared_arm", "cobot_joint"};
  const auto cases = study::run_misfit_study(options);
  ASSERT_EQ(cases.size(), options.joints.size() * (1 + study::lacks().size()));
  for (const study::MisfitCase& c : cases) {
    SCOPED_TRACE(c.joint + " " + c.disturbance);
    EXPECT_FALSE(c.has_cause);
    for (const study::MisfitQuantity& q : c.quantities) {
      // The Stribeck velocity of few speeds rests on the shape of the dip.
      if (q.quantity == joint::Quantity::stribeck_speed) continue;
      EXPECT_EQ(q.wrong_usable, 0U) << to_string(q.quantity);
    }
    const bool has_no_loops =
        c.disturbance == "one_sweep" || c.disturbance == "sweep_and_three_runs";
    EXPECT_EQ(quantity(c, joint::Quantity::gravity_torque).usable, c.runs);
    EXPECT_EQ(quantity(c, joint::Quantity::bristle_stiffness).found == 0,
              has_no_loops || c.disturbance == "encoder_12_bits");
    if (c.disturbance == "sweep_and_three_runs") {
      EXPECT_EQ(quantity(c, joint::Quantity::coulomb_torque).usable, c.runs);
    }
  }
}

TEST(MisfitStudy, OutliersOfTheTorqueDoNotHideAWarmUp) {
  simulate::Scenario s = study::misfit_joints().at(1).scenario;
  s.effects.warm_up = 0.2;
  s.noise.effects.outlier_Nm = 0.6;
  for (const double percent : {0.0, 0.2, 1.0}) {
    s.noise.effects.outlier_percent = percent;
    const calibration::Calibration c = identify::identify(simulate::simulated_dataset(s));
    EXPECT_EQ(c.torque_outliers.replaced > 0, percent > 0);
    const StatedValue drift("effect", Statement("effect.drift"));
    EXPECT_TRUE(std::any_of(c.judgement.findings.begin(), c.judgement.findings.end(),
                            [&](const Statement& one) {
                              return one.is("model.effect_shows") &&
                                     std::find(one.values().begin(), one.values().end(), drift) !=
                                         one.values().end();
                            }))
        << percent;
    const method::model::ModelEffect* found = c.model.find("drift");
    ASSERT_NE(found, nullptr) << percent;
    // A fifth of the friction is lost, most of it before the runs.
    EXPECT_NEAR(found->largest_Nm.value / c.model.friction_Nm, 0.15, 0.08) << percent;
  }
}

TEST(MisfitStudy, RefusesWhatThereIsNot) {
  EXPECT_THROW(study::run_misfit_study(on_the_arm("bad_weather")), std::invalid_argument);
  study::MisfitOptions elsewhere = on_the_arm("warm_up");
  elsewhere.joints = {"elbow"};
  EXPECT_THROW(study::run_misfit_study(elsewhere), std::invalid_argument);
}

TEST(MisfitStudy, MeasuresAnErrorByWhatMatters) {
  EXPECT_DOUBLE_EQ(study::bound_of(joint::Quantity::surrogate_mass, 80), 0.08);
  EXPECT_DOUBLE_EQ(study::bound_of(joint::Quantity::inertia, -2), 0.5);
}

}  // namespace
}  // namespace tribolog::misfit_test
