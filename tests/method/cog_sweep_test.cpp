#include "method/gravity/cog_sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulate/motion.h"
#include "statistics/random_stream.h"
#include "support/breadth.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::cog_sweep_test {
namespace {

constexpr double degree = std::numbers::pi / 180;

method::gravity::CogSweepResult rough_of(const joint::Dataset& d) {
  return method::gravity::identify_cog_sweep(
             method::gravity::SweepKind::rough,
             method::motion::Sweep(d.with_role(joint::Role::rough_sweep)), 100)
      .result;
}

method::gravity::CogSweepResult precise_of(
    const joint::Dataset& d, const std::optional<method::gravity::KnownGravity>& known = {}) {
  return method::gravity::identify_cog_sweep(
             method::gravity::SweepKind::precise,
             method::motion::Sweep(d.with_role(joint::Role::precise_sweep)), 100, true, known)
      .result;
}

method::gravity::KnownGravity known_by(const method::gravity::CogSweepResult& sweep) {
  return {sweep.gravity_Nm.value, sweep.q_peak_rad.value};
}

/// A robot's slow sine at the joint, with Coulomb, viscous, inertia, noise and a coarse encoder.
joint::Recording slow_sine(double q_peak, double gravity, std::uint64_t seed) {
  statistics::RandomStream random(seed, 0);
  const auto motion = simulate::HarmonicMotion::sine(q_peak - 0.5, 1.2, 0.1);
  joint::Recording r;
  r.name = "sine.csv";
  for (double t = 0; t < 50; t += 0.01) {
    const double w = motion.speed(t);
    r.t_s.push_back(t);
    r.q_rad.push_back(1e-4 * std::floor(motion.angle(t) / 1e-4));
    r.torque_Nm.push_back(gravity * std::cos(motion.angle(t) - q_peak) + 14 * std::tanh(w / 1e-3) +
                          18 * w + 20 * motion.acceleration(t) + 0.5 + 2.5 * random.normal());
  }
  return r;
}

TEST(CogSweep, NoiseFreeSweepsGiveTheExactAngle) {
  const joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  const method::gravity::CogSweepResult rough = rough_of(d);
  ASSERT_TRUE(rough.found);
  EXPECT_EQ(rough.stage.state, statistics::StageState::done);
  EXPECT_TRUE(rough.constant_speed);
  EXPECT_TRUE(rough.both_directions);
  EXPECT_NEAR(rough.q_peak_rad.value, test::true_q_peak_rad(), 1e-9);
  EXPECT_NEAR(rough.gravity_Nm.value, test::true_gravity_Nm, 1e-9);
  // Friction at 2 deg/s, half the distance of the directions.
  const double friction = test::paper_curve().torque_Nm(100 * 2 * degree);
  ASSERT_TRUE(rough.coulomb_Nm);
  EXPECT_NEAR(rough.coulomb_Nm->value, friction, 1e-9);
  // Arg-max: no better than the sampling.
  EXPECT_NEAR(rough.argmax_rad, test::true_q_peak_rad(), 2 * degree / 1000);
  EXPECT_EQ(rough.samples_used + rough.samples_left_out, d.recordings.front().size());

  const method::gravity::CogSweepResult precise = precise_of(d, known_by(rough));
  ASSERT_TRUE(precise.found);
  EXPECT_NEAR(precise.q_peak_rad.value, test::true_q_peak_rad(), 1e-7);
}

TEST(CogSweep, PreciseSweepAloneGivesTheAngleToo) {
  const joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  const method::gravity::CogSweepResult precise = precise_of(d);
  ASSERT_TRUE(precise.found);
  EXPECT_NEAR(precise.q_peak_rad.value, test::true_q_peak_rad(), 1e-7);
}

// About the trough the same amplitude bends the torque the other way.
TEST(CogSweep, AMirroredPreciseSweepGivesTheMirroredAngle) {
  joint::Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(3));
  const method::gravity::CogSweepResult rough = rough_of(d);
  const method::gravity::CogSweepResult precise = precise_of(d, known_by(rough));
  for (joint::Recording& recording : d.recordings) {
    for (std::vector<double>* values :
         {&recording.q_rad, &recording.dq_rad_s, &recording.torque_Nm}) {
      for (double& value : *values) value = -value;
    }
  }
  const method::gravity::CogSweepResult rough_mirrored = rough_of(d);
  const method::gravity::CogSweepResult mirrored = precise_of(d, known_by(rough_mirrored));
  ASSERT_TRUE(precise.found && mirrored.found);
  const double half_turn = std::numbers::pi;
  EXPECT_NEAR(std::remainder(mirrored.q_peak_rad.value + precise.q_peak_rad.value - half_turn,
                             2 * half_turn),
              0, 1e-12);
  EXPECT_NEAR(mirrored.q_peak_rad.half_width(), precise.q_peak_rad.half_width(), 1e-12);
  ASSERT_TRUE(precise.torque_offset_Nm && mirrored.torque_offset_Nm);
  EXPECT_NEAR(mirrored.torque_offset_Nm->value, -precise.torque_offset_Nm->value, 1e-12);
}

TEST(CogSweep, NoisyIntervalsCoverTheTruth) {
  int angle = 0;
  int amplitude = 0;
  constexpr int seeds = 100;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    simulate::Scenario s = test::noisy_paper_joint(seed);
    s.precise_sweep.reset();
    s.oscillation.reset();
    s.constant_speed.reset();
    s.rough_sweep->sample_rate_Hz = 200;
    const method::gravity::CogSweepResult rough = rough_of(simulate::simulated_dataset(s));
    angle += rough.q_peak_rad.low <= test::true_q_peak_rad() &&
             test::true_q_peak_rad() <= rough.q_peak_rad.high;
    amplitude += rough.gravity_Nm.low <= test::true_gravity_Nm &&
                 test::true_gravity_Nm <= rough.gravity_Nm.high;
    // Where the arg-max may lie: its own interval has to hold the truth.
    EXPECT_LE(rough.argmax_low_rad, test::true_q_peak_rad());
    EXPECT_GE(rough.argmax_high_rad, test::true_q_peak_rad());
  }
  EXPECT_GE(angle, 89);
  EXPECT_GE(amplitude, 89);
}

TEST(CogSweep, OneDirectionIsSaidToBeOne) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep->both_directions = false;
  const joint::Dataset d = simulate::simulated_dataset(s);
  const method::gravity::CogSweepResult rough = rough_of(d);
  ASSERT_TRUE(rough.found);
  EXPECT_FALSE(rough.both_directions);
  EXPECT_EQ(rough.stage.state, statistics::StageState::partial);
  EXPECT_NE(wording::words(rough.stage.reason).find("one direction"), std::string::npos);
  EXPECT_NEAR(rough.q_peak_rad.value, test::true_q_peak_rad(), 1e-9);
}

TEST(CogSweep, ASweepThatMissesThePeakSaysSo) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep->from_rad = 10 * degree;
  const joint::Dataset d = simulate::simulated_dataset(s);
  const method::gravity::CogSweepResult rough = rough_of(d);
  ASSERT_TRUE(rough.found);
  EXPECT_TRUE(rough.argmax_at_end);
  EXPECT_EQ(rough.stage.state, statistics::StageState::partial);
  EXPECT_NE(wording::words(rough.stage.reason).find("does not cross"), std::string::npos);
  EXPECT_NEAR(rough.q_peak_rad.value, test::true_q_peak_rad(), 1e-6);
}

TEST(CogSweep, SlowSinesInBothDirectionsGiveAngleGravityAndFriction) {
  for (const double q_peak : {-1.6, 0.3, -3.13}) {
    const joint::Recording r = slow_sine(q_peak, 109, 11);
    const method::gravity::CogSweepResult sweep =
        method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough,
                                            method::motion::Sweep({&r}), 1.0)
            .result;
    ASSERT_TRUE(sweep.found) << q_peak;
    EXPECT_FALSE(sweep.constant_speed);
    EXPECT_NEAR(sweep.q_peak_rad.value, q_peak, 0.02);
    EXPECT_NEAR(sweep.gravity_Nm.value, 109, 1.0);
    EXPECT_NEAR(sweep.coulomb_Nm->value, 14, 0.5);
    EXPECT_NEAR(sweep.viscous_Nms_rad->value, 18, 0.8);
    EXPECT_NEAR(sweep.inertia_kgm2->value, 20, 4);
  }
}

TEST(CogSweep, WithoutGravityThereIsNoAngle) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const joint::Recording r = slow_sine(0.3, 0.0, seed);
    const method::gravity::CogSweepResult sweep =
        method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough,
                                            method::motion::Sweep({&r}), 1.0)
            .result;
    EXPECT_FALSE(sweep.found) << "seed " << seed << ": " << sweep.gravity_Nm.value << " N·m";
    EXPECT_EQ(sweep.stage.state, statistics::StageState::not_identifiable);
  }
}

/// A long slow sweep of a geared joint there and back, at constant speed; the angle is that of the
/// motor.
struct LaidOn {
  double offset_Nm{}, drift_Nm{};  ///< The drift over the recording.
  double ripple_Nm{}, vibration_Nm{}, coloured_Nm{};
};

joint::Recording long_sweep(const LaidOn& laid, std::uint64_t seed) {
  statistics::RandomStream random(seed, 0);
  constexpr double q_peak = 0.2;
  constexpr double duration_s = 120;
  constexpr double step_s = 0.01;
  double motor = q_peak - 1.1;
  joint::Recording r;
  r.name = "long.csv";
  double coloured = 0;
  for (double t = 0; t < duration_s; t += step_s) {
    const double wave = std::sin(2 * std::numbers::pi * t / duration_s);
    const double w = 0.04 * std::clamp(20 * wave, -1.0, 1.0);
    motor += w * step_s;
    constexpr double keep = 0.9;  // a tenth of a second
    coloured = keep * coloured + laid.coloured_Nm * std::sqrt(1 - keep * keep) * random.normal();
    r.t_s.push_back(t);
    r.q_rad.push_back(motor);
    r.torque_Nm.push_back(4 * std::cos(motor - q_peak) + 0.6 * std::tanh(w / 1e-3) + 0.3 * w +
                          laid.offset_Nm + laid.drift_Nm * (t / duration_s - 0.5) +
                          laid.ripple_Nm * std::cos(100 * 3 * motor) +
                          laid.vibration_Nm * std::sin(2 * std::numbers::pi * 7.3 * t) + coloured +
                          0.02 * random.normal());
  }
  return r;
}

method::gravity::CogSweepResult swept(const joint::Recording& r) {
  return method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough,
                                             method::motion::Sweep({&r}), 100)
      .result;
}

TEST(CogSweep, AnOffsetAndItsDriftAreNotGravity) {
  const auto sweep = swept(long_sweep({.offset_Nm = 0.1, .drift_Nm = 0.08}, 3));
  ASSERT_TRUE(sweep.torque_offset_Nm);
  EXPECT_NEAR(sweep.torque_offset_Nm->value, 0.1, 0.01);
  EXPECT_NEAR(sweep.gravity_Nm.value, 4, 0.01);
}

TEST(CogSweep, ResidualsAreAttributedToTheirCause) {
  const auto ripple = swept(long_sweep({.ripple_Nm = 0.05}, 4));
  ASSERT_EQ(ripple.ripple.lines.size(), 1U);
  EXPECT_NEAR(ripple.ripple.lines.front().periods_per_turn, 3, 0.01);
  EXPECT_NEAR(ripple.ripple.lines.front().amplitude_Nm, 0.05, 0.003);
  EXPECT_TRUE(ripple.vibration.empty());
  const auto vibration = swept(long_sweep({.vibration_Nm = 0.05}, 5));
  ASSERT_FALSE(vibration.vibration.empty());
  EXPECT_NEAR(vibration.vibration.front().frequency_Hz, 7.3, 0.01);
  EXPECT_NEAR(vibration.vibration.front().amplitude_Nm, 0.05, 0.003);
  EXPECT_TRUE(vibration.ripple.lines.empty());
  const auto coloured = swept(long_sweep({.coloured_Nm = 0.06}, 6));
  EXPECT_NEAR(coloured.coloured_Nm, 0.06, 0.015);
  EXPECT_TRUE(coloured.ripple.lines.empty());
  EXPECT_LT(coloured.ripple_Nm, 0.02);
}

TEST(CogSweep, WithoutGravityFrictionAloneIsRead) {
  const joint::Recording r = long_sweep({.offset_Nm = 0.1}, 2);
  joint::Recording free = r;
  for (std::size_t i = 0; i < free.size(); ++i) free.torque_Nm[i] -= 4 * std::cos(r.q_rad[i] - 0.2);
  const auto sweep = method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough,
                                                         method::motion::Sweep({&free}), 100, false)
                         .result;
  EXPECT_FALSE(sweep.found);
  ASSERT_TRUE(sweep.coulomb_Nm && sweep.torque_offset_Nm);
  EXPECT_NEAR(sweep.coulomb_Nm->value, 0.612, 0.005);
  EXPECT_NEAR(sweep.torque_offset_Nm->value, 0.1, 0.005);
}

TEST(CogSweep, NothingRecordedIsSkippedWithAnInstruction) {
  const method::gravity::CogSweepResult none =
      method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough, {}, 1.0).result;
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.stage.state, statistics::StageState::skipped);
  EXPECT_NE(wording::words(none.stage.reason).find("slow sweep"), std::string::npos);
}

TEST(CogSweep, AStandingJointIsNotIdentifiable) {
  joint::Recording r;
  for (int i = 0; i < 1000; ++i) {
    r.t_s.push_back(i * 0.01);
    r.q_rad.push_back(0.5);
    r.torque_Nm.push_back(3);
  }
  const method::gravity::CogSweepResult sweep =
      method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough,
                                          method::motion::Sweep({&r}), 1.0)
          .result;
  EXPECT_FALSE(sweep.found);
  EXPECT_EQ(sweep.stage.state, statistics::StageState::not_identifiable);
}

}  // namespace
}  // namespace tribolog::cog_sweep_test
