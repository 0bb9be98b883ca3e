// Effects that the method's model does not have, each by what it does to an ideal log.

#include "simulate/unmodelled_effects.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "joint/degrees.h"
#include "support/paper_joint.h"

namespace tribolog::unmodelled_effects_test {
namespace {

using simulate::Scenario;

Scenario short_joint() {
  Scenario s = test::paper_joint();
  s.precise_sweep.reset();
  s.rough_sweep->speed_rad_s *= 10;
  s.constant_speed->motor_speeds_rad_s = {3, 30};
  return s;
}

const joint::Recording& of_role(const std::vector<joint::Recording>& all, joint::Role role) {
  return *std::find_if(all.begin(), all.end(),
                       [&](const joint::Recording& r) { return r.role == role; });
}

TEST(UnmodelledEffects, OfNoSizeLeaveEveryBitAsItWas) {
  const Scenario s = short_joint();
  EXPECT_FALSE(s.effects.any());
  EXPECT_FALSE(s.noise.effects.any());
  const std::vector<joint::Recording> plain = simulate::simulate_joint(s);
  joint::Recording r = plain.front();
  simulate::add_torque_effects(r, {}, 1000, 1, 0);
  simulate::add_log_effects(r, {}, 1, 0);
  EXPECT_EQ(r.torque_Nm, plain.front().torque_Nm);
}

TEST(AbsentEffects, AreAllThatASoundScenarioLeavesOut) {
  namespace effect = joint::effect;
  Scenario s = short_joint();
  s.noise.ripple.clear();
  for (const joint::Effect& one : joint::statable_effects()) {
    const bool is_law = one.key == effect::law_misfit.key;  // the paper's is Waiboer's
    EXPECT_EQ(simulate::absent_effects(s).is_stated(one), !is_law) << one.key;
    EXPECT_TRUE(is_law || simulate::absent_effects(s).of(one) == 0) << one.key;
  }
  s.sliding = nullptr;  // LuGre's own curve
  EXPECT_TRUE(simulate::absent_effects(s).is_stated(effect::law_misfit));
  s.noise.effects.mirrored_angle = true;
  EXPECT_FALSE(simulate::absent_effects(s).stated().empty());
  // Slow over the joint's turn a ripple is a torque over its angle.
  s.noise.ripple.push_back({0.01, 2, 0});
  EXPECT_TRUE(simulate::absent_effects(s).is_stated(effect::smooth_over_angle));
  s.gear_ratio = 2;
  EXPECT_FALSE(simulate::absent_effects(s).is_stated(effect::smooth_over_angle));
}

TEST(AbsentEffects, AreNotStatedWhereJointOrLogHaveOne) {
  Scenario s = short_joint();
  s.effects.spring_Nm_rad = 0.01;
  EXPECT_TRUE(simulate::absent_effects(s).stated().empty());
  s.effects = {};
  s.noise.effects.torque_delay_s = 1e-3;
  EXPECT_TRUE(simulate::absent_effects(s).stated().empty());
}

TEST(UnmodelledEffects, WhatALogHoldsIsHeldWithItsNoise) {
  Scenario s = short_joint();
  s.noise.torque_white_Nm = 0.01;
  s.noise.speed_filter_Hz = 100;
  const auto noisy = simulate::simulate_joint(s);
  s.noise.effects.dead_percent = 100;
  s.noise.effects.speed_scale = 0.5;
  const auto dead = simulate::simulate_joint(s);
  for (std::size_t k = 0; k < dead.size(); ++k) {
    const std::vector<double>& torque = dead[k].torque_Nm;
    EXPECT_EQ(std::count(torque.begin(), torque.end(), torque.front()),
              static_cast<std::ptrdiff_t>(torque.size()));
    EXPECT_DOUBLE_EQ(dead[k].dq_rad_s.back(), 0.5 * noisy[k].dq_rad_s.back());
  }
  s.noise.effects = {};
  s.noise.effects.held_percent = 20;
  const std::vector<double> held = simulate::simulate_joint(s).front().torque_Nm;
  std::size_t equal = 0;
  for (std::size_t i = 1; i < held.size(); ++i) equal += held[i] == held[i - 1] ? 1 : 0;
  EXPECT_GT(static_cast<double>(equal), 0.1 * static_cast<double>(held.size()));
}

TEST(UnmodelledEffects, AnOffsetIsThereInEverySample) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.effects.torque_offset_Nm = 0.1;
  const auto with = simulate::simulate_joint(s);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    for (std::size_t i = 0; i < plain[k].size(); i += 100) {
      EXPECT_NEAR(with[k].torque_Nm[i] - plain[k].torque_Nm[i], 0.1, 1e-12);
    }
  }
}

TEST(UnmodelledEffects, AsymmetryMovesTheMeanOfTheDirectionsByItsShareOfFriction) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.effects.direction_asymmetry = 0.1;
  const auto with = simulate::simulate_joint(s);
  const joint::Recording& before = of_role(plain, joint::Role::constant_speed);
  const joint::Recording& after = of_role(with, joint::Role::constant_speed);
  for (std::size_t i = 0; i < before.size(); ++i) {
    // 10 % more upwards, and 10 % less of a negative torque downwards.
    EXPECT_GE(after.torque_Nm[i] - before.torque_Nm[i], -1e-12);
  }
  const std::size_t upwards = before.size() / 4;
  EXPECT_NEAR(after.torque_Nm[upwards] - before.torque_Nm[upwards],
              0.1 * std::abs(s.sliding->torque_Nm(3)), 1e-6);
}

TEST(UnmodelledEffects, FrictionByTheMotorsAngleHasItsPeriodsToTheTurnAndNoMean) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.effects.friction_by_motor_angle = 0.1;
  s.effects.periods_per_motor_turn = 2;
  const auto with = simulate::simulate_joint(s);
  const joint::Recording& before = of_role(plain, joint::Role::rough_sweep);
  const joint::Recording& after = of_role(with, joint::Role::rough_sweep);
  const double friction = std::abs(s.sliding->torque_Nm(s.gear_ratio * s.rough_sweep->speed_rad_s));
  double mean = 0;
  std::size_t samples = 0;
  for (std::size_t i = before.size() / 10; i < before.size() * 2 / 5; ++i) {
    const double change = after.torque_Nm[i] - before.torque_Nm[i];
    EXPECT_NEAR(change, 0.1 * friction * std::cos(2 * s.gear_ratio * before.q_rad[i]), 1e-6);
    mean += change;
    ++samples;
  }
  EXPECT_NEAR(mean / static_cast<double>(samples), 0, 0.001 * friction);
}

TEST(UnmodelledEffects, ABentViscousTorqueIsTheSameAtItsOwnSpeed) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.effects.viscous_exponent = 1.5;
  s.effects.bent_viscous_Nms_rad = 0.002;
  s.effects.bent_viscous_rad_s = 30;
  const auto with = simulate::simulate_joint(s);
  const auto change = [&](std::size_t k, std::size_t i) {
    return with[k].torque_Nm[i] - plain[k].torque_Nm[i];
  };
  const std::size_t fast = plain.size() - 1;
  const std::size_t upwards = plain[fast].size() / 4;
  EXPECT_NEAR(change(fast, upwards), 0, 1e-9);
  // At a tenth of that speed: 0.002 w (0.1^0.5 - 1), and the other way round on the way back.
  const std::size_t slow = fast - 1;
  const double expected = 0.002 * 3 * (std::sqrt(0.1) - 1);
  EXPECT_NEAR(change(slow, plain[slow].size() / 4), expected, 1e-9);
  EXPECT_NEAR(change(slow, plain[slow].size() * 3 / 4), -expected, 1e-9);
}

TEST(UnmodelledEffects, WarmingUpTakesItsShareAtTheEndOfTheSession) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.effects.warm_up = 0.2;
  const auto with = simulate::simulate_joint(s);
  const auto slide = [](const joint::Recording& r) { return r.torque_Nm[r.size() * 2 / 5]; };
  const double lost = slide(plain.back()) - slide(with.back());
  EXPECT_NEAR(lost, 0.2 * std::abs(s.sliding->torque_Nm(30)) * 0.95, 0.01);
  EXPECT_NEAR(slide(plain.front()) - slide(with.front()), 0, 0.08);
}

TEST(UnmodelledEffects, AGearThatTwistsShowsItsPeakWhereTheMotorStandsThen) {
  Scenario s = short_joint();
  s.effects.gear_windup_rad = 0.5 * joint::rad_per_degree;
  const auto with = simulate::simulate_joint(s);
  const joint::Recording& sweep = of_role(with, joint::Role::rough_sweep);
  const auto half = sweep.torque_Nm.begin() + static_cast<std::ptrdiff_t>(sweep.size() / 2);
  const auto at = std::max_element(sweep.torque_Nm.begin(), half) - sweep.torque_Nm.begin();
  EXPECT_NEAR(sweep.q_rad[static_cast<std::size_t>(at)],
              s.load.q_peak_rad() + s.effects.gear_windup_rad, 2e-3);
}

TEST(UnmodelledEffects, GearLossAndLoadFrictionAreTheSameInSliding) {
  Scenario s = short_joint();
  s.effects.gear_loss = 0.03;
  const auto loss = simulate::simulate_joint(s);
  s.effects = {.load_friction = 0.03};
  const auto load = simulate::simulate_joint(s);
  const joint::Recording& a = of_role(loss, joint::Role::rough_sweep);
  const joint::Recording& b = of_role(load, joint::Role::rough_sweep);
  const std::size_t i = a.size() / 4;
  EXPECT_NEAR(a.torque_Nm[i], b.torque_Nm[i], 1e-9);
  // In pre-sliding the one jumps, the other builds up.
  const joint::Recording& jumps = of_role(loss, joint::Role::oscillation);
  const joint::Recording& builds = of_role(load, joint::Role::oscillation);
  double largest = 0;
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    largest = std::max(largest, std::abs(jumps.torque_Nm[k] - builds.torque_Nm[k]));
  }
  EXPECT_GT(largest, 0.05);
}

TEST(UnmodelledEffects, ADelayedTorqueIsThatOfBefore) {
  Scenario s = short_joint();
  s.noise = {};
  const auto plain = simulate::simulate_joint(s);
  s.noise.effects.torque_delay_s = 0.004;
  const auto late = simulate::simulate_joint(s);
  const joint::Recording& a = plain.front();
  const joint::Recording& b = late.front();
  for (std::size_t i = 4; i < a.size(); i += 50) {
    EXPECT_NEAR(b.torque_Nm[i], a.torque_Nm[i - 4], 1e-9);
  }
}

TEST(UnmodelledEffects, AMirroredLogIsTheSameJointTheOtherWayRound) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.noise.effects = {.mirrored_angle = true, .mirrored_torque = true};
  const auto mirrored = simulate::simulate_joint(s);
  for (std::size_t i = 0; i < plain.front().size(); i += 100) {
    EXPECT_EQ(mirrored.front().q_rad[i], -plain.front().q_rad[i]);
    EXPECT_EQ(mirrored.front().torque_Nm[i], -plain.front().torque_Nm[i]);
  }
}

/// Share of the recordings of a role whose torque is another one.
double share_changed(const std::vector<joint::Recording>& before,
                     const std::vector<joint::Recording>& after, joint::Role role) {
  double all = 0;
  double changed = 0;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (before[k].role != role) continue;
    ++all;
    changed += before[k].torque_Nm == after[k].torque_Nm ? 0 : 1;
  }
  return changed / all;
}

Scenario joint_with_ramps() {
  Scenario s = short_joint();
  s.break_away = {.centre_rad = s.load.q_peak_rad(), .rate_Nm_s = 0.5, .largest_torque_Nm = 2};
  return s;
}

TEST(UnmodelledEffects, AViscousTorqueBentTheOtherWayIsNoneAtRest) {
  Scenario s = short_joint();
  s.effects.viscous_exponent = 0.9;
  s.effects.bent_viscous_Nms_rad = 0.002;
  s.effects.bent_viscous_rad_s = 30;
  for (const joint::Recording& r : simulate::simulate_joint(s)) {
    EXPECT_TRUE(std::all_of(r.torque_Nm.begin(), r.torque_Nm.end(), [](double torque) {
      return std::isfinite(torque);
    })) << r.name;
  }
}

TEST(UnmodelledEffects, AControllersCoulombModelIsAddedWithTheSignOfTheSpeed) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.noise.effects.coulomb_model_Nm = 0.2;
  s.noise.effects.coulomb_model_from_rad_s = 0.01;
  const auto with = simulate::simulate_joint(s);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    for (std::size_t i = 0; i < plain[k].size(); i += 50) {
      EXPECT_NEAR(with[k].torque_Nm[i] - plain[k].torque_Nm[i],
                  0.2 * std::tanh(plain[k].dq_rad_s[i] / 0.01), 1e-12);
    }
  }
}

TEST(UnmodelledEffects, OscillationsAndRunsHaveScalesOfTheirOwn) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.noise.effects.scale_of_loops = 1.2;
  s.noise.effects.scale_of_runs = 0.9;
  const auto with = simulate::simulate_joint(s);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const double scale = plain[k].role == joint::Role::oscillation      ? 1.2
                         : plain[k].role == joint::Role::constant_speed ? 0.9
                                                                        : 1;
    for (std::size_t i = 0; i < plain[k].size(); i += 50) {
      EXPECT_DOUBLE_EQ(with[k].torque_Nm[i], scale * plain[k].torque_Nm[i]);
    }
  }
}

TEST(UnmodelledEffects, AnUnevenGearTwistsByWhereTheLoadStands) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  const double windup = s.effects.gear_windup_rad = 0.5 * joint::rad_per_degree;
  const double uneven = s.effects.uneven_windup = 0.5;
  const auto with = simulate::simulate_joint(s);
  const joint::Recording& a = plain.front();
  const joint::Recording& b = with.front();
  const double gravity = s.load.amplitude_Nm() / s.gear_ratio;
  std::size_t looked_at = 0;
  for (std::size_t i = 0; i < a.size(); i += 50) {
    const double away = a.q_rad[i] - s.load.q_peak_rad();
    if (std::abs(std::sin(away)) < 0.2) continue;  // there an angle is not known by its cosine
    ++looked_at;
    const double cosine = std::cos(away) + (b.torque_Nm[i] - a.torque_Nm[i]) / gravity;
    const double load = a.q_rad[i] - away + std::copysign(std::acos(cosine), away);
    EXPECT_NEAR(a.q_rad[i] - load, windup * (1 + uneven * std::sin(load)) * cosine, 1e-9);
  }
  EXPECT_GT(looked_at, 0U);
}

TEST(UnmodelledEffects, AResonantFilterOvershootsAStepAsItsQualitySays) {
  joint::Recording r;
  constexpr double rate_Hz = 10000;
  for (int i = 0; i < 10000; ++i) {
    r.t_s.push_back(i / rate_Hz);
    r.q_rad.push_back(0);
    r.dq_rad_s.push_back(0);
    r.torque_Nm.push_back(i < 100 ? 1 : 3);
  }
  simulate::add_torque_effects(r, {.resonance_Hz = 50, .resonance_quality = 3}, rate_Hz, 1, 0);
  EXPECT_DOUBLE_EQ(r.torque_Nm[99], 1);
  const double overshoot = 2 * std::exp(-std::numbers::pi / std::sqrt(4.0 * 9 - 1));
  EXPECT_NEAR(*std::max_element(r.torque_Nm.begin(), r.torque_Nm.end()), 3 + overshoot, 1e-3);
  EXPECT_NEAR(r.torque_Nm.back(), 3, 1e-9);
}

TEST(UnmodelledEffects, CrosstalkHasOneAndTwoPeriodsInATurn) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.noise.effects.crosstalk_Nm = 0.05;
  s.noise.effects.crosstalk_zero_rad = 0.3;
  const auto with = simulate::simulate_joint(s);
  for (std::size_t i = 0; i < plain.front().size(); i += 50) {
    const double angle = plain.front().q_rad[i] - 0.3;
    EXPECT_NEAR(with.front().torque_Nm[i] - plain.front().torque_Nm[i],
                0.05 * (std::sin(angle) + std::sin(2 * angle)), 1e-12);
  }
}

TEST(UnmodelledEffects, AHandLeansOnSweepsAndSomeRunsForASecondOrTwo) {
  Scenario s = short_joint();
  s.constant_speed->motor_speeds_rad_s.assign(20, 10);
  const auto plain = simulate::simulate_joint(s);
  s.noise.effects.touch_Nm = 0.3;
  const auto with = simulate::simulate_joint(s);
  EXPECT_EQ(share_changed(plain, with, joint::Role::rough_sweep), 1);
  EXPECT_EQ(share_changed(plain, with, joint::Role::oscillation), 0);
  EXPECT_NEAR(share_changed(plain, with, joint::Role::constant_speed), 1.0 / 3, 0.25);
  double touched_s = 0;
  double largest = 0;
  const joint::Recording& sweep = plain.front();
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const double change = with.front().torque_Nm[i] - sweep.torque_Nm[i];
    touched_s += change != 0 ? sweep.t_s[1] - sweep.t_s[0] : 0;
    largest = std::max(largest, change);
  }
  EXPECT_NEAR(touched_s, std::min(1.5, sweep.t_s.back() / 4), 0.01);
  EXPECT_NEAR(largest, 0.3, 1e-3);
}

TEST(UnmodelledEffects, AnotherToolIsThereFromTheFirstRunOn) {
  Scenario s = joint_with_ramps();
  const auto plain = simulate::simulate_joint(s);
  s.effects.tool_gravity = 0.1;
  const auto with = simulate::simulate_joint(s);
  EXPECT_EQ(share_changed(plain, with, joint::Role::rough_sweep), 0);
  EXPECT_EQ(share_changed(plain, with, joint::Role::oscillation), 0);
  for (const joint::Role role : {joint::Role::constant_speed, joint::Role::break_away}) {
    const joint::Recording& a = of_role(plain, role);
    const joint::Recording& b = of_role(with, role);
    EXPECT_NEAR(b.torque_Nm.front() - a.torque_Nm.front(),
                0.1 * s.load.torque_Nm(a.q_rad.front()) / s.gear_ratio, 1e-9);
  }
}

TEST(UnmodelledEffects, RowsOfMessagesThatDoNotComeRepeatAllChannels) {
  Scenario s = short_joint();
  s.noise.effects.repeated_percent = 20;
  double all = 0;
  double repeated = 0;
  for (const joint::Recording& r : simulate::simulate_joint(s)) {
    if (r.role != joint::Role::rough_sweep) continue;
    for (std::size_t i = 1; i < r.size(); ++i) {
      const bool is_stuck = r.q_rad[i] == r.q_rad[i - 1] && r.dq_rad_s[i] == r.dq_rad_s[i - 1] &&
                            r.torque_Nm[i] == r.torque_Nm[i - 1];
      repeated += is_stuck ? 1 : 0;
      ++all;
    }
  }
  EXPECT_NEAR(repeated / all, 0.2, 0.07);
}

TEST(UnmodelledEffects, OneRunIsOfAnotherJoint) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.effects.foreign_run = 2;
  s.effects.foreign_friction = 3;
  const auto with = simulate::simulate_joint(s);
  EXPECT_EQ(share_changed(plain, with, joint::Role::constant_speed), 0.5);
  EXPECT_EQ(share_changed(plain, with, joint::Role::rough_sweep), 0);
  const std::size_t upwards = plain.back().size() / 4;
  EXPECT_NEAR(with.back().torque_Nm[upwards] - plain.back().torque_Nm[upwards],
              2 * s.sliding->torque_Nm(30), 1e-6);
}

TEST(UnmodelledEffects, GravityThatAControllerKeepsToItselfIsInNoRecording) {
  Scenario s = joint_with_ramps();
  const auto plain = simulate::simulate_joint(s);
  s.effects.gravity_left_out = 0.9;
  const auto with = simulate::simulate_joint(s);
  for (std::size_t k = 0; k < plain.size(); ++k) {
    ASSERT_EQ(plain[k].size(), with[k].size());
    for (std::size_t i = 0; i < plain[k].size(); i += 50) {
      EXPECT_NEAR(with[k].torque_Nm[i] - plain[k].torque_Nm[i],
                  -0.9 * s.load.torque_Nm(plain[k].q_rad[i]) / s.gear_ratio, 1e-9);
    }
  }
}

TEST(UnmodelledEffects, EachRecordingHasATareOfItsOwn) {
  Scenario s = short_joint();
  const auto plain = simulate::simulate_joint(s);
  s.noise.effects.tare_Nm = 0.1;
  const auto with = simulate::simulate_joint(s);
  EXPECT_EQ(with.back().torque_Nm, simulate::simulate_joint(s).back().torque_Nm);
  std::vector<double> tares;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    tares.push_back(with[k].torque_Nm.front() - plain[k].torque_Nm.front());
    for (std::size_t i = 0; i < plain[k].size(); i += 50) {
      EXPECT_NEAR(with[k].torque_Nm[i] - plain[k].torque_Nm[i], tares.back(), 1e-12);
    }
    EXPECT_LT(std::abs(tares.back()), 0.5);
  }
  EXPECT_GT(std::abs(tares.front() - tares.back()), 1e-3);
}

TEST(FrictionChange, IsWhatEffectsMakeOfSlidingFriction) {
  Scenario s = short_joint();
  s.effects.direction_asymmetry = 0.1;
  s.effects.warm_up = 0.2;
  s.effects.load_friction = 0.03;
  const double q = s.load.q_peak_rad();
  const auto rising = friction_change(s, q, 1, 0, joint::Role::constant_speed);
  EXPECT_DOUBLE_EQ(rising.factor, 1.1);
  EXPECT_DOUBLE_EQ(rising.of_load_Nm, 0.03 * s.load.amplitude_Nm() / s.gear_ratio);
  const auto falling = friction_change(s, q, -1, 1, joint::Role::constant_speed);
  EXPECT_NEAR(falling.factor, 0.9 * (1 - 0.2 * (1 - std::exp(-3.0))), 1e-12);
}

}  // namespace
}  // namespace tribolog::unmodelled_effects_test
