#include "method/gravity/cog_sweep.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulate/motion.h"
#include "statistics/random_stream.h"
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
    const joint::Dataset& d, const std::optional<statistics::Estimate>& gravity_Nm = {}) {
  return method::gravity::identify_cog_sweep(
             method::gravity::SweepKind::precise,
             method::motion::Sweep(d.with_role(joint::Role::precise_sweep)), 100, gravity_Nm)
      .result;
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

  const method::gravity::CogSweepResult precise = precise_of(d, rough.gravity_Nm);
  ASSERT_TRUE(precise.found);
  EXPECT_NEAR(precise.q_peak_rad.value, test::true_q_peak_rad(), 1e-7);
}

TEST(CogSweep, PreciseSweepAloneGivesTheAngleToo) {
  const joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  const method::gravity::CogSweepResult precise = precise_of(d);
  ASSERT_TRUE(precise.found);
  EXPECT_NEAR(precise.q_peak_rad.value, test::true_q_peak_rad(), 1e-7);
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
