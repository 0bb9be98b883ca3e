// Each effect of the catalogue at three times its typical size: the numbers stay inside their
// intervals, and the data show the effect, or another of the same columns.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"

namespace tribolog::model_effects_test {
namespace {

using joint::Quantity;
using method::model::ModelQuantity;
using method::model::ModelResult;
using test::found;
using test::friction_at;
using test::holds;
using test::KnownJoint;
using test::SmallEffects;

struct Injected {
  std::string name;
  std::vector<std::string> seen_as;  ///< One of these.
  std::function<void(SmallEffects&)> inject;
  test::Session session{};
};

/// Over most of a turn: over less of it a spring is a part of gravity.
test::Session wide() {
  test::Session session;
  session.low_rad = -2.9;
  session.high_rad = 2.7;
  return session;
}

void PrintTo(const Injected& one, std::ostream* out) { *out << one.name; }

class InjectedEffect : public testing::TestWithParam<Injected> {};

TEST_P(InjectedEffect, IsShownAndLeavesTheNumbersInsideTheirIntervals) {
  constexpr std::uint64_t seeds = 5;
  int shown = 0;
  int inside = 0;
  int asked = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    KnownJoint joint;
    joint.noise_Nm = 0.003;
    const ModelResult without =
        record(joint, GetParam().session, seed).identified(joint.gear_ratio);
    GetParam().inject(joint.effects);
    const ModelResult with = record(joint, GetParam().session, seed).identified(joint.gear_ratio);
    const auto ask = [&](const ModelQuantity& q, double truth, const std::string& name) {
      ++asked;
      if (holds(q, truth)) {
        ++inside;
      } else {
        std::cout << GetParam().name << ", seed " << seed << ": " << name << " " << q.estimate
                  << " (" << q.low << " to " << q.high << "), truth " << truth << "\n";
      }
    };
    ask(found(with, Quantity::gravity_torque), joint.gravity_Nm, "gravity");
    ask(found(with, Quantity::cog_angle), joint.q_peak_rad, "angle");
    ask(found(with, Quantity::coulomb_torque), joint.coulomb_Nm, "Coulomb");
    ask(found(with, Quantity::viscous_coefficient), joint.viscous_Nms_rad, "viscous");
    ask(found(with, Quantity::inertia), joint.inertia_kgm2, "inertia");
    for (const double speed : {3.0, 10.0, 30.0}) {
      const ModelQuantity& q = friction_at(with, speed);
      ask(q, joint.friction_Nm(q.speed_rad_s), "friction at " + std::to_string(speed));
    }
    const bool is_shown = std::any_of(GetParam().seen_as.begin(), GetParam().seen_as.end(),
                                      [&](const std::string& key) {
                                        return found(with, key).chi2 > found(without, key).chi2 + 5;
                                      });
    shown += is_shown ? 1 : 0;
  }
  std::cout << GetParam().name << ": inside " << inside << " of " << asked << ", shown " << shown
            << " of " << seeds << "\n";
  EXPECT_GE(inside, 0.95 * asked);
  EXPECT_EQ(shown, seeds);
}

INSTANTIATE_TEST_SUITE_P(
    ModelEffects, InjectedEffect,
    testing::Values(
        Injected{"offset", {"offset"}, [](SmallEffects& e) { e.offset = 0.04; }},
        Injected{"offset_drift", {"offset_drift"}, [](SmallEffects& e) { e.offset_drift = 0.006; }},
        Injected{"lag", {"lag", "position"}, [](SmallEffects& e) { e.lag_s = 0.004; }},
        Injected{"load", {"load"}, [](SmallEffects& e) { e.load = 0.03; }},
        Injected{"asymmetry", {"asymmetry"}, [](SmallEffects& e) { e.asymmetry_of_speed = 0.06; }},
        Injected{"position",
                 {"position", "load"},
                 [](SmallEffects& e) { e.place = {0.06, -0.03, 0.02, 0.015, -0.012}; }},
        Injected{"drift", {"drift", "law_misfit"}, [](SmallEffects& e) { e.warm_up[1] = 0.1; }},
        Injected{"hoses",
                 {"hoses", "harmonics", "smooth_over_angle", "angle_scale"},
                 [](SmallEffects& e) { e.spring = 0.003; },
                 wide()},
        Injected{"torque_nonlinear", {"torque_nonlinear"}, [](SmallEffects& e) { e.cube = 0.01; }},
        Injected{"gain_of_runs",
                 {"gain_of_runs", "gain_drift", "gain_of_speed"},
                 [](SmallEffects& e) { e.gain_of_runs = 0.006; }},
        Injected{"gain_of_speed",
                 {"gain_of_speed", "load", "torque_nonlinear"},
                 [](SmallEffects& e) { e.gain_of_speed = 0.01; }},
        Injected{"tool", {"tool"}, [](SmallEffects& e) { e.tool = 0.02; }},
        Injected{"tare", {"tare"}, [](SmallEffects& e) { e.tare = 0.005; }},
        Injected{"motor_turn", {"motor_turn"}, [](SmallEffects& e) { e.motor_turn = 0.1; }},
        Injected{"angle_scale",
                 {"angle_scale", "harmonics"},
                 [](SmallEffects& e) { e.angle_scale = 0.01; },
                 wide()},
        Injected{"peak_drift", {"peak_drift"}, [](SmallEffects& e) { e.peak_drift_rad = 0.01; }},
        Injected{"smooth_over_angle",
                 {"smooth_over_angle", "harmonics"},
                 [](SmallEffects& e) { e.waves = {0.003, 0.002, 0, 0.002, 0, 0.001}; }},
        Injected{"gain_drift",
                 {"gain_drift", "gain_of_runs"},
                 [](SmallEffects& e) { e.gain_drift = 0.006; }},
        Injected{"harmonics",
                 {"harmonics", "smooth_over_angle"},
                 [](SmallEffects& e) { e.harmonics = {0, 0.002, 0.0015, 0}; }}),
    [](const testing::TestParamInfo<Injected>& one) { return one.param.name; });

TEST(EffectSizes, StatedAsTypicalIsTheSameToTheBit) {
  const KnownJoint joint;
  const test::JointLog log = record(joint, {}, 1);
  joint::EffectSizes typical;
  for (const joint::Effect& one : joint::statable_effects()) {
    // Of a coarse log the lag that nobody states is a share of the interval.
    if (one.key != joint::effect::lag.key) typical.state(one, one.typical);
  }
  const auto of = [&](const joint::EffectSizes& sizes) {
    return method::model::identify_joint(log.all(), {}, joint.gear_ratio, true, sizes);
  };
  const ModelResult plain = of({});
  const ModelResult stated = of(typical);
  ASSERT_EQ(plain.quantities.size(), stated.quantities.size());
  for (std::size_t k = 0; k < plain.quantities.size(); ++k) {
    EXPECT_EQ(plain.quantities[k].estimate, stated.quantities[k].estimate);
    EXPECT_EQ(plain.quantities[k].low, stated.quantities[k].low);
    EXPECT_EQ(plain.quantities[k].high, stated.quantities[k].high);
  }
}

TEST(EffectSizes, StatedAsZeroIsNotInTheModel) {
  const KnownJoint joint;
  const test::JointLog log = record(joint, {}, 1);
  joint::EffectSizes none;
  for (const joint::Effect& one : joint::statable_effects()) none.state(one, 0);
  const ModelResult result =
      method::model::identify_joint(log.all(), {}, joint.gear_ratio, true, none);
  for (const method::model::ModelEffect& one : result.effects) {
    EXPECT_TRUE(one.key == "gravity" || one.key == "inertia") << one.key;
  }
  const ModelResult plain = log.identified(joint.gear_ratio);
  for (const Quantity quantity : {Quantity::gravity_torque, Quantity::cog_angle,
                                  Quantity::coulomb_torque, Quantity::viscous_coefficient}) {
    EXPECT_LT(test::half_width(found(result, quantity)), test::half_width(found(plain, quantity)));
  }
}

TEST(Lag, IsFoundEitherWayAndLeavesTheInertia) {
  int inside = 0;
  int asked = 0;
  for (const double lag_s : {-0.012, -0.001, 0.0, 0.001, 0.012}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      KnownJoint joint;
      joint.noise_Nm = 0.003;
      joint.effects.lag_s = lag_s;
      const ModelResult result = record(joint, {}, seed).identified(joint.gear_ratio);
      const statistics::Estimate lag = *found(result, "lag").coefficient;
      ++asked;
      inside += lag.low <= lag_s && lag_s <= lag.high ? 1 : 0;
      EXPECT_LT(lag.half_width(), 2.5e-3) << lag_s;
      EXPECT_NEAR(found(result, Quantity::inertia).estimate, joint.inertia_kgm2,
                  0.03 * joint.inertia_kgm2)
          << lag_s;
      if (lag_s == 0) continue;
      // It is told although it was taken off the torque before the last fit.
      if (std::abs(lag_s) > 0.01) {
        EXPECT_GT(found(result, "lag").chi2, 10) << lag_s;
      }
      std::cout << "  " << lag_s << ": " << lag.value << " (" << lag.low << " to " << lag.high
                << ")\n";
    }
  }
  std::cout << "  " << inside << " of " << asked << " inside\n";
  EXPECT_GE(inside, 0.9 * asked);
}

/// Two seconds at one angle, where the joint pre-slides.
joint::Recording stay(joint::Role role, double q_rad) {
  joint::Recording r;
  r.role = role;
  for (int i = 0; i < 400; ++i) {
    r.t_s.push_back(0.005 * i);
    r.q_rad.push_back(q_rad);
    r.torque_Nm.push_back(0.1 * std::sin(0.1 * i));
  }
  return r;
}

TEST(FrictionOfLoopsAndRamps, GrowsWithTheLoadWhereTheyStand) {
  KnownJoint joint;
  joint.noise_Nm = 0.003;
  joint.effects.load = 0.05;
  test::JointLog log = record(joint, {}, 1);
  EXPECT_FALSE(log.identified(joint.gear_ratio).friction_of_loops) << "there are none";
  log.recordings.push_back(stay(joint::Role::oscillation, joint.q_peak_rad));
  log.recordings.push_back(stay(joint::Role::break_away, joint.q_peak_rad - 1.5708));
  const ModelResult result = log.identified(joint.gear_ratio);
  ASSERT_TRUE(result.friction_of_loops && result.friction_of_ramps);
  const statistics::Estimate& loaded = *result.friction_of_loops;
  const statistics::Estimate& unloaded = *result.friction_of_ramps;
  const double truth = joint.effects.load * joint.gravity_Nm / result.friction_Nm;
  EXPECT_NEAR(loaded.value - unloaded.value, truth,
              std::hypot(loaded.half_width(), unloaded.half_width()));
  EXPECT_LT(loaded.half_width(), 0.5 * truth);
  EXPECT_GT(loaded.low, unloaded.high);
}

TEST(FrictionOfLoopsAndRamps, IsThatOfTheRunsWhereNothingChangesIt) {
  KnownJoint joint;
  joint.noise_Nm = 0.003;
  test::JointLog log = record(joint, {}, 1);
  log.recordings.push_back(stay(joint::Role::oscillation, joint.q_peak_rad));
  const ModelResult result = log.identified(joint.gear_ratio);
  ASSERT_TRUE(result.friction_of_loops);
  EXPECT_LT(result.friction_of_loops->low, 0);
  EXPECT_GT(result.friction_of_loops->high, 0);
  EXPECT_LT(result.friction_of_loops->half_width(), 0.05);
}

TEST(GainOfLoops, IsThatOfATorqueOutOfProportionUnderTheirLoad) {
  KnownJoint joint;
  joint.noise_Nm = 0.003;
  for (const double square : {0.0, 0.02}) {
    joint.effects.square = square;
    test::JointLog log = record(joint, {}, 1);
    EXPECT_FALSE(log.identified(joint.gear_ratio).gain_of_loops) << "there are none";
    log.recordings.push_back(stay(joint::Role::oscillation, joint.q_peak_rad));
    const ModelResult result = log.identified(joint.gear_ratio);
    ASSERT_TRUE(result.gain_of_loops);
    // The slope of M + square M |M| / top, M the gravity torque.
    const double truth = 2 * square * joint.gravity_Nm / result.top_Nm;
    EXPECT_LT(result.gain_of_loops->low, truth);
    EXPECT_GT(result.gain_of_loops->high, truth);
    EXPECT_LT(result.gain_of_loops->half_width(), 0.03);
    EXPECT_EQ(result.gain_of_loops->low > 0, square > 0);
  }
}

/// Another joint swings beside the tested one, and the log has its angle.
test::JointLog beside_another(const KnownJoint& joint, double its_gravity_Nm) {
  test::JointLog log = record(joint, {}, 3);
  for (joint::Recording& r : log.recordings) {
    std::vector<double> other;
    for (std::size_t i = 0; i < r.size(); ++i) {
      other.push_back(0.3 + 0.9 * std::sin(0.7 * r.t_s[i]));
      r.torque_Nm[i] += its_gravity_Nm * std::cos(r.q_rad[i] + other.back());
    }
    r.others_q_rad = {other};
  }
  return log;
}

TEST(OtherJoints, WhoseAnglesAreLoggedLeaveTheFrictionInItsInterval) {
  const KnownJoint joint;
  for (const double its_gravity_Nm : {0.0, 0.05, 0.2}) {
    const test::JointLog log = beside_another(joint, its_gravity_Nm);
    const ModelResult result = log.identified(joint.gear_ratio);
    EXPECT_TRUE(holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm));
    EXPECT_TRUE(holds(found(result, Quantity::viscous_coefficient), joint.viscous_Nms_rad));
    EXPECT_LT(test::half_width(found(result, Quantity::coulomb_torque)), 0.1 * joint.coulomb_Nm);
    EXPECT_GE(found(result, "others_gravity").torque_Nm, 0.5 * its_gravity_Nm);
  }
}

}  // namespace
}  // namespace tribolog::model_effects_test
