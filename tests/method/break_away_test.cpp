// Ramps of an independent solver over a LuGre joint: its static torque must come back.

#include "method/hysteresis/break_away.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include <gtest/gtest.h>

#include "friction/lugre.h"
#include "simulate/drive_noise.h"
#include "simulate/forced_motion.h"
#include "statistics/random_stream.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::break_away_test {
namespace {

constexpr double gear_ratio = 100;
constexpr double static_Nm = 0.88;

/// Found this much below the static torque at most: by definition 0.7 %, and a little for the
/// window over which the speed is taken.
constexpr double share_below = 0.015;

struct Ramp {
  double rate_Nm_s{0.1};
  double duration_s{12};
  double stiffness_Nm_rad{465};
  double q_start_rad{test::true_q_peak_rad()};
  double arm_inertia_kgm2{0};  // lets a fast ramp rise past break-away before it shows
  double friction_by_motor_angle{0};
};

joint::Recording ramp_of(const Ramp& ramp) {
  simulate::Scenario s = test::paper_joint();
  s.presliding = std::make_shared<friction::LuGreFriction>(friction::LuGreFriction::Parameters{
      ramp.stiffness_Nm_rad, 0.77, 0.001, 0.60, static_Nm, 5.0});
  s.motor_inertia_kgm2 = 2e-3;
  s.arm_inertia_kgm2 = ramp.arm_inertia_kgm2;
  s.effects.friction_by_motor_angle = ramp.friction_by_motor_angle;
  simulate::BreakAwayExperiment e;
  e.centre_rad = ramp.q_start_rad;
  e.rate_Nm_s = std::abs(ramp.rate_Nm_s);
  e.largest_torque_Nm = ramp.duration_s * e.rate_Nm_s;
  e.largest_travel_rad = 10;  // the whole of it, until gravity catches the arm
  return simulate::simulate_break_away_ramp(s, e, ramp.rate_Nm_s < 0 ? -1.0 : 1.0, "ramp.csv");
}

const method::hysteresis::KnownGravity true_gravity{
    statistics::symmetric_estimate(test::true_gravity_Nm, 1e-3), test::true_q_peak_rad()};

TEST(BreakAway, ANoisyTorqueBeforeTheRampDoesNotTurnIt) {
  joint::Recording r = ramp_of({0.1, 12});
  const method::hysteresis::BreakAwayResult clean =
      method::hysteresis::identify_break_away({&r}, {true_gravity});
  ASSERT_TRUE(clean.ramps.front().broke_away);
  // Against the ramp, and further than a tenth of it.
  for (const std::size_t i : {20U, 31U, 55U}) r.torque_Nm[i] -= 0.3;
  const method::hysteresis::BreakAwayResult noisy =
      method::hysteresis::identify_break_away({&r}, {true_gravity});
  const method::hysteresis::BreakAwayRamp& found = noisy.ramps.front();
  EXPECT_TRUE(found.is_rising);
  EXPECT_TRUE(found.broke_away);
  EXPECT_NEAR(found.friction_Nm, clean.ramps.front().friction_Nm, 0.005);
}

/// At 48 samples a second, the torque's noise a fifth of what it breaks away at, the angle without
/// a step before it slides for a fifth of a second.
joint::Recording coarse_ramp(double slip_at_s) {
  statistics::RandomStream noise(3, 1);
  joint::Recording r;
  r.name = "coarse.csv";
  double q_rad = 0;
  for (int i = 0; i < 720; ++i) {
    const double t = i / 48.0;
    if (t > slip_at_s) q_rad += 0.075 * (t - slip_at_s);
    r.t_s.push_back(t);
    r.q_rad.push_back(4e-4 * std::round(q_rad / 4e-4));
    r.torque_Nm.push_back(0.036 * t + 0.1 * noise.normal());
  }
  return r;
}

TEST(BreakAway, AShortSlideIsSeenByAnEncoderThatNeverFlickered) {
  const joint::Recording slides = coarse_ramp(14.8);
  const joint::Recording rests = coarse_ramp(100);
  const auto found = method::hysteresis::identify_break_away({&slides, &rests}, {});
  ASSERT_EQ(found.ramps.size(), 2U);
  EXPECT_TRUE(found.ramps[0].broke_away);
  EXPECT_TRUE(found.ramps[0].is_rising);
  EXPECT_NEAR(found.ramps[0].torque_Nm, 0.533, 0.06);  // of one sample: 0.2
  EXPECT_FALSE(found.ramps[1].broke_away);
}

TEST(BreakAway, FindsTheStaticTorqueWhateverRateAndStiffness) {
  for (const double rate : {0.1, 0.4, -0.1}) {
    for (const double stiffness : {465.0, 4650.0}) {
      const joint::Recording r = ramp_of({rate, 1.2 / std::abs(rate), stiffness});
      const method::hysteresis::BreakAwayResult result =
          method::hysteresis::identify_break_away({&r}, {true_gravity});
      ASSERT_EQ(result.ramps.size(), 1U);
      const method::hysteresis::BreakAwayRamp& found = result.ramps.front();
      EXPECT_TRUE(found.broke_away);
      EXPECT_EQ(found.is_rising, rate > 0);
      EXPECT_LT(found.friction_Nm, 1.01 * static_Nm);  // a fast ramp: damping and inertia add
      EXPECT_NEAR(found.friction_Nm, static_Nm, share_below * static_Nm) << rate << stiffness;
      EXPECT_NEAR(found.rate_Nm_s, std::abs(rate), 1e-9);
      // Upwards nothing stops the arm; downwards gravity, which falls off with the cosine, does.
      EXPECT_EQ(found.first_slip_rad.has_value(), rate < 0);
      EXPECT_EQ(found.samples_used + found.samples_left_out, r.size());
    }
  }
}

/// Held at a constant torque before the ramp, on an encoder that flickers by a step.
TEST(BreakAway, TheRestBeforeTheRampIsNoneOfIt) {
  joint::Recording r = ramp_of({0.1, 12});
  const double dt = r.t_s[1] - r.t_s[0];
  constexpr std::size_t rest = 3000;
  joint::Recording held = r;
  for (auto* signal : {&held.t_s, &held.q_rad, &held.torque_Nm}) {
    signal->insert(signal->begin(), rest, signal->front());
  }
  for (std::size_t i = 0; i < held.size(); ++i) held.t_s[i] = static_cast<double>(i) * dt;
  for (std::size_t i = rest - 40; i < rest; ++i) held.q_rad[i] += 1e-9 * static_cast<double>(i % 2);
  const auto result = method::hysteresis::identify_break_away({&held}, {true_gravity});
  ASSERT_TRUE(result.ramps.front().broke_away);
  EXPECT_NEAR(result.ramps.front().friction_Nm, static_Nm, share_below * static_Nm);
}

/// A heavy direct drive speeds up over a second: it has slid long before it is thirty times as fast
/// as on average.
TEST(BreakAway, AHeavyJointThatRunsAwaySlowlyHasBrokenAway) {
  simulate::Scenario s = test::paper_joint();
  s.presliding = std::make_shared<friction::LuGreFriction>(
      friction::LuGreFriction::Parameters{2e4, 30, 1.2, 1.4, 1.9, 0.06});
  s.gear_ratio = 1;
  s.motor_inertia_kgm2 = 2;
  s.arm_inertia_kgm2 = 0;
  simulate::BreakAwayExperiment e;
  e.centre_rad = test::true_q_peak_rad();
  e.rate_Nm_s = 1.3;
  e.largest_torque_Nm = 6;
  e.largest_travel_rad = 0.03;
  const joint::Recording r = simulate::simulate_break_away_ramp(s, e, 1.0, "ramp.csv");
  const double gravity = s.load.amplitude_Nm();
  const auto result = method::hysteresis::identify_break_away(
      {&r}, {method::hysteresis::KnownGravity{statistics::symmetric_estimate(gravity, 1e-3),
                                              s.load.q_peak_rad()}});
  ASSERT_TRUE(result.ramps.front().broke_away) << result.ramps.front().largest_yield;
  EXPECT_NEAR(result.ramps.front().level_Nm.value_or(0), 1.9, 0.05);
}

TEST(BreakAway, TheRestingPartTellsTheLevelOfARampTooFastForTheJoint) {
  Ramp fast{0.5, 3};
  fast.arm_inertia_kgm2 = 20;
  const joint::Recording r = ramp_of(fast);
  const double inertia_at_joint = 20.0 / gear_ratio + 2e-3 * gear_ratio;
  const auto bare = method::hysteresis::identify_break_away({&r, &r}, {true_gravity});
  EXPECT_GT(bare.ramps.front().friction_Nm, 1.01 * static_Nm);  // what is read is not held
  const auto result =
      method::hysteresis::identify_break_away({&r, &r}, {true_gravity, inertia_at_joint});
  ASSERT_TRUE(result.is_level);
  ASSERT_TRUE(result.rising_Nm);
  EXPECT_NEAR(result.rising_Nm->value, static_Nm, 0.01 * static_Nm);
  EXPECT_GT(result.ramps.front().inertia_Nm, 0);
  EXPECT_LT(result.ramps.front().friction_Nm, bare.ramps.front().friction_Nm);
}

/// While the torque rises the bristle's damping bears a part of it that no break-away will need.
TEST(BreakAway, TheDampingOfTheBristleIsNotPartOfTheLevel) {
  constexpr double behind_s = 0.77 / 465;
  for (const double rate : {1.0, -1.0}) {
    const joint::Recording r = ramp_of({rate, 1.2});
    const auto level = [&](const method::hysteresis::BehindTorque& behind) {
      return method::hysteresis::identify_break_away(
          {&r, &r}, {true_gravity, 2e-3 * gear_ratio, gear_ratio, {}, behind});
    };
    const auto with_damping = level({});
    const auto found = level({behind_s, behind_s / 2});
    ASSERT_TRUE(found.is_level);
    const double excess_Nm = *with_damping.ramps.front().level_Nm - static_Nm;
    EXPECT_NEAR(excess_Nm, behind_s, 0.3 * behind_s) << rate;  // at 1 N·m/s
    EXPECT_NEAR(*found.ramps.front().level_Nm, static_Nm, 0.3 * excess_Nm) << rate;
    // As far as the damping is known.
    const auto& stated = rate > 0 ? found.rising_Nm : found.falling_Nm;
    EXPECT_GE(stated->half_width(), 0.9 * behind_s / 2);
  }
}

/// Such a joint is seen to run away when its friction has fallen to Coulomb torque already.
TEST(BreakAway, AHeavyJointIsReadWhereItHeldMost) {
  Ramp fast{0.5, 3};
  fast.arm_inertia_kgm2 = 20;
  const joint::Recording r = ramp_of(fast);
  const double inertia_at_joint = 20.0 / gear_ratio + 2e-3 * gear_ratio;
  const auto result =
      method::hysteresis::identify_break_away({&r, &r}, {true_gravity, inertia_at_joint});
  const method::hysteresis::BreakAwayRamp& ramp = result.ramps.front();
  EXPECT_NEAR(ramp.friction_Nm, static_Nm, 0.04 * static_Nm);
  EXPECT_GE(ramp.inertia_half_width_Nm, 0.25 * std::abs(ramp.inertia_Nm) - 1e-12);
}

/// One ramp of three that does not bend far enough does not take the level from the others.
TEST(BreakAway, MostRampsTellTheLevel) {
  const joint::Recording fine = ramp_of({0.1, 12});
  joint::Recording coarse = fine;
  const double step = static_Nm / 465 / gear_ratio;
  for (double& q : coarse.q_rad) q = step * std::round(q / step);
  const auto all = method::hysteresis::identify_break_away({&fine, &fine, &coarse}, {true_gravity});
  ASSERT_FALSE(all.ramps.back().level_Nm);
  EXPECT_TRUE(all.is_level);
  EXPECT_NEAR(all.rising_Nm ? all.rising_Nm->value : 0, static_Nm, 0.01 * static_Nm);
  EXPECT_FALSE(
      method::hysteresis::identify_break_away({&fine, &coarse, &coarse}, {true_gravity}).is_level);
}

/// What accelerates shifts both directions alike: their mean is no better known for it.
TEST(BreakAway, TheInertiaIsNotAveragedAwayOverTheDirections) {
  Ramp rising{0.5, 3};
  rising.arm_inertia_kgm2 = 20;
  Ramp falling = rising;
  falling.rate_Nm_s = -falling.rate_Nm_s;
  std::deque<joint::Recording> ramps{ramp_of(rising), ramp_of(falling)};
  for (joint::Recording& r : ramps) {
    for (double& q : r.q_rad) q = 1e-4 * std::round(q / 1e-4);  // no level is seen
  }
  const double inertia_at_joint = 20.0 / gear_ratio + 2e-3 * gear_ratio;
  const auto result = method::hysteresis::identify_break_away(
      {&ramps[0], &ramps[0], &ramps[1], &ramps[1]}, {true_gravity, inertia_at_joint});
  ASSERT_FALSE(result.is_level);
  ASSERT_TRUE(result.mean_Nm);
  double of_inertia = 0;
  for (const auto& ramp : result.ramps) of_inertia += ramp.inertia_half_width_Nm / 4;
  ASSERT_GT(of_inertia, 0);
  EXPECT_GE(result.mean_Nm->half_width(), 0.999 * of_inertia);
}

/// The joint bends by some ten steps of the encoder, wherever within a step it starts.
TEST(BreakAway, AnEncoderOfFewStepsDoesNotShiftTheLevel) {
  const joint::Recording fine = ramp_of({0.1, 12});
  const double bend = static_Nm / 465 / gear_ratio;
  const double step = bend / 8;
  for (const double phase : {0.0, 0.2, 0.4, 0.6, 0.8}) {
    joint::Recording r = fine;
    for (double& q : r.q_rad) q = step * std::round((q - fine.q_rad.front()) / step + phase);
    for (double& q : r.q_rad) q += fine.q_rad.front();
    const auto result = method::hysteresis::identify_break_away({&r, &r}, {true_gravity});
    ASSERT_TRUE(result.is_level) << phase;
    EXPECT_NEAR(result.ramps.front().level_Nm.value_or(0), static_Nm, 0.01 * static_Nm) << phase;
  }
}

TEST(BreakAway, ARampThatEndsBeforeIsABoundAndNoValue) {
  const joint::Recording r = ramp_of({0.1, 8});
  const method::hysteresis::BreakAwayResult result =
      method::hysteresis::identify_break_away({&r}, {true_gravity});
  EXPECT_FALSE(result.ramps.front().broke_away);
  EXPECT_NEAR(result.ramps.front().friction_Nm, 0.8, 1e-6);
  EXPECT_EQ(result.censored, 1U);
  EXPECT_FALSE(result.rising_Nm);
  EXPECT_EQ(result.stage.state, statistics::StageState::not_identifiable);
  EXPECT_NE(wording::words(result.stage.reason).find("larger than 0.8 N·m (censored"),
            std::string::npos);
}

TEST(BreakAway, CensoredRampsDoNotPullTheMeanDown) {
  const joint::Recording whole = ramp_of({0.1, 12});
  const joint::Recording faster = ramp_of({0.2, 6});
  const joint::Recording early = ramp_of({0.1, 5});
  const method::hysteresis::BreakAwayResult result =
      method::hysteresis::identify_break_away({&whole, &early, &faster}, {true_gravity});
  ASSERT_TRUE(result.rising_Nm);
  EXPECT_NEAR(result.rising_Nm->value, static_Nm, share_below * static_Nm);
  EXPECT_EQ(result.censored, 1U);
  EXPECT_EQ(result.stage.state, statistics::StageState::partial);
}

/// A position loop moves the joint on at an even speed, from where friction held it the other way:
/// LuGre without inertia, its exact solution.
joint::Recording position_ramp(double sign, double ways) {
  constexpr double rest_s = 0.5;
  constexpr double slide_s = 6;
  const double way = static_Nm / 465 / gear_ratio;
  joint::Recording r;
  r.name = "position_ramp.csv";
  for (double t = 0; t < rest_s + slide_s; t += 0.002) {
    const double travel = std::max(0.0, t - rest_s) / slide_s * ways * way;
    const double q = test::true_q_peak_rad() + sign * travel;
    r.t_s.push_back(t);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(test::true_gravity_Nm * std::cos(q - test::true_q_peak_rad()) +
                          sign * static_Nm * (1 - 2 * std::exp(-travel / way)));
  }
  return r;
}

TEST(BreakAway, AJointThatIsMovedOnByItsPositionSlides) {
  for (const double ways : {12.0, 100.0}) {
    const joint::Recording up = position_ramp(1, ways);
    const joint::Recording down = position_ramp(-1, ways);
    const auto result = method::hysteresis::identify_break_away({&up, &up, &down, &down},
                                                                {true_gravity, 0, gear_ratio});
    EXPECT_EQ(result.censored, 0U) << ways;
    ASSERT_TRUE(result.mean_Nm) << ways;
    EXPECT_NEAR(result.mean_Nm->value, static_Nm, 0.002 * static_Nm) << ways;
    const method::hysteresis::BreakAwayRamp& ramp = result.ramps.front();
    EXPECT_FALSE(ramp.first_slip_rad);
    EXPECT_NEAR(ramp.even_slide_rad_s.value_or(0), ways * static_Nm / 465 / gear_ratio / 6,
                0.1 * ways * static_Nm / 465 / gear_ratio / 6);
  }
  const joint::Recording ends_early = position_ramp(1, 3);
  EXPECT_EQ(method::hysteresis::identify_break_away({&ends_early}, {true_gravity}).censored, 1U);
}

TEST(BreakAway, BothDirectionsTogetherNeedNoGravity) {
  // Off the peak, where gravity differs between the directions' ends by next to nothing.
  std::deque<joint::Recording> ramps;
  std::vector<const joint::Recording*> given;
  for (const double rate : {0.1, -0.1, 0.12, -0.12}) {
    ramps.push_back(ramp_of({rate, 1.2 / std::abs(rate), 465, -1.0}));
    given.push_back(&ramps.back());
  }
  const method::hysteresis::BreakAwayResult blind =
      method::hysteresis::identify_break_away(given, {});
  ASSERT_TRUE(blind.mean_Nm);
  EXPECT_NEAR(blind.mean_Nm->value, static_Nm, share_below * static_Nm);
  EXPECT_GT(blind.rising_Nm->value, 2 * static_Nm);  // gravity is in it, and the report says so
  EXPECT_EQ(blind.stage.state, statistics::StageState::partial);
  const method::hysteresis::BreakAwayResult known =
      method::hysteresis::identify_break_away(given, {true_gravity});
  EXPECT_NEAR(known.rising_Nm->value, known.falling_Nm->value, 0.01 * static_Nm);
  EXPECT_EQ(known.stage.state, statistics::StageState::done);
}

TEST(BreakAway, HoldsInTheNoiseOfARealDrive) {
  simulate::Noise noise;
  noise.torque_white_Nm = 0.02;
  noise.torque_step_Nm = 0.005;
  noise.encoder_counts_per_turn = 131072;
  const joint::Recording clean = ramp_of({});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    joint::Recording r = clean;
    noise.seed = seed;
    simulate::add_drive_noise(r, noise, gear_ratio, 1000, 0);
    const method::hysteresis::BreakAwayResult result =
        method::hysteresis::identify_break_away({&r}, {true_gravity});
    ASSERT_TRUE(result.ramps.front().broke_away) << seed;
    // One reading of the torque: three standard deviations of its noise.
    EXPECT_NEAR(result.ramps.front().friction_Nm, static_Nm, share_below * static_Nm + 0.06);
  }
}

/// Recorded up to where a drive would stop it, a little after break-away.
joint::Recording ramp_that_stops(double rate_Nm_s) {
  joint::Recording r = ramp_of({rate_Nm_s, 1.2 / rate_Nm_s});
  const double bristle_rad = static_Nm / 465 / gear_ratio;
  std::size_t end = 0;
  while (end < r.size() && std::abs(r.q_rad[end] - r.q_rad.front()) < 20 * bristle_rad) ++end;
  for (auto* signal : {&r.t_s, &r.q_rad, &r.torque_Nm}) signal->resize(end);
  return r;
}

TEST(BreakAway, IsSeenWhereNoiseIsLargestBeforeIt) {
  simulate::Noise noise;
  noise.torque_white_Nm = 0.03;
  const joint::Recording clean = ramp_that_stops(0.4);
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    joint::Recording r = clean;
    noise.seed = seed;
    simulate::add_drive_noise(r, noise, gear_ratio, 1000, 0);
    EXPECT_TRUE(
        method::hysteresis::identify_break_away({&r}, {true_gravity}).ramps.front().broke_away)
        << seed;
  }
}

TEST(BreakAway, ABoundIsNotRaisedByNoise) {
  simulate::Noise noise;
  noise.torque_white_Nm = 0.03;
  const joint::Recording clean = ramp_of({0.1, 8});
  int above = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    joint::Recording r = clean;
    noise.seed = seed;
    simulate::add_drive_noise(r, noise, gear_ratio, 1000, 0);
    const auto result = method::hysteresis::identify_break_away({&r}, {true_gravity});
    ASSERT_FALSE(result.ramps.front().broke_away) << seed;
    EXPECT_NEAR(result.ramps.front().friction_Nm, 0.8, 0.06) << seed;
    above += result.ramps.front().friction_Nm > 0.8 ? 1 : 0;
  }
  EXPECT_LE(above, 4);  // of 40, one is expected
}

/// Three ramps with a drive's noise at each of these motor angles from the gravity peak, where
/// friction changes by 8 %, twice a motor turn.
std::deque<joint::Recording> ramps_at(const std::vector<double>& motor_angles) {
  simulate::Noise noise;
  noise.torque_white_Nm = 0.005;
  std::deque<joint::Recording> ramps;
  for (const double motor_rad : motor_angles) {
    Ramp ramp;
    ramp.q_start_rad += motor_rad / gear_ratio;
    ramp.friction_by_motor_angle = 0.08;
    const joint::Recording clean = ramp_of(ramp);
    for (std::size_t k = 0; k < 3; ++k) {
      ramps.push_back(clean);
      simulate::add_drive_noise(ramps.back(), noise, gear_ratio, 1000, ramps.size());
    }
  }
  return ramps;
}

std::optional<statistics::Estimate> rising_of(const std::deque<joint::Recording>& ramps,
                                              const method::gravity::CogSweepResult& sweep = {}) {
  std::vector<const joint::Recording*> given;
  for (const joint::Recording& r : ramps) given.push_back(&r);
  return method::hysteresis::identify_break_away(given, {true_gravity, 0, gear_ratio, sweep})
      .rising_Nm;
}

TEST(BreakAway, RampsAroundTheMotorsTurnHoldTheMeanOverAllAngles) {
  std::vector<double> angles;
  for (int k = 0; k < 5; ++k) angles.push_back(1.1 * k);
  const auto mean = rising_of(ramps_at(angles));
  ASSERT_TRUE(mean);
  EXPECT_LE(mean->low, static_Nm);
  EXPECT_GE(mean->high, static_Nm);
  // 5.7 % of effects, at five angles.
  EXPECT_GT(mean->half_width(), 0.03 * static_Nm);
  EXPECT_LT(mean->half_width(), 0.15 * static_Nm);
}

TEST(BreakAway, RampsAtOneAngleHoldWhatTheSweepShowsOfTheOthers) {
  const std::deque<joint::Recording> ramps = ramps_at({0.0});
  const auto alone = rising_of(ramps);
  method::gravity::CogSweepResult sweep;
  sweep.found = true;
  sweep.coulomb_Nm = statistics::symmetric_estimate(0.6, 0.001);
  sweep.friction_of_angle.lines = {{2, 0.08 * 0.6, 0.3}};
  sweep.friction_by_angle_Nm = sweep.friction_of_angle.sd_Nm();
  const auto with_sweep = rising_of(ramps, sweep);
  ASSERT_TRUE(alone && with_sweep);
  EXPECT_NEAR(alone->value, with_sweep->value, 1e-6 * static_Nm);
  EXPECT_LT(alone->half_width(), 0.02 * static_Nm);
  EXPECT_LE(with_sweep->low, static_Nm);
  EXPECT_GE(with_sweep->high, static_Nm);
  EXPECT_LT(with_sweep->half_width(), 0.15 * static_Nm);
}

TEST(BreakAway, ASlipThatIsCaughtIsMeasured) {
  // The joint yields, jumps by 0.02 rad within 50 ms, and creeps on.
  joint::Recording r;
  for (int i = 0; i < 20000; ++i) {
    const double t = 1e-3 * i;
    const double jump = 0.02 * std::clamp((t - 15) / 0.05, 0.0, 1.0);
    r.t_s.push_back(t);
    r.q_rad.push_back(1e-5 * t + jump);
    r.torque_Nm.push_back(0.5 * t);
  }
  const method::hysteresis::BreakAwayResult result =
      method::hysteresis::identify_break_away({&r}, {});
  ASSERT_TRUE(result.ramps.front().broke_away);
  EXPECT_NEAR(result.ramps.front().torque_Nm, 7.5, 0.05);
  ASSERT_TRUE(result.ramps.front().first_slip_rad);
  EXPECT_NEAR(*result.ramps.front().first_slip_rad, 0.02, 0.001);
}

TEST(BreakAway, NothingRecordedIsSaidAndNotThrown) {
  EXPECT_EQ(method::hysteresis::identify_break_away({}, {}).stage.state,
            statistics::StageState::skipped);
  joint::Recording still;
  for (int i = 0; i < 100; ++i) {
    still.t_s.push_back(i);
    still.q_rad.push_back(0.5);
    still.torque_Nm.push_back(0.1 * i);
  }
  const method::hysteresis::BreakAwayResult result =
      method::hysteresis::identify_break_away({&still}, {});
  EXPECT_FALSE(result.ramps.front().broke_away);
  EXPECT_EQ(result.stage.state, statistics::StageState::not_identifiable);
  const joint::Recording empty;
  EXPECT_TRUE(method::hysteresis::identify_break_away({&empty}, {}).ramps.empty());
}

}  // namespace
}  // namespace tribolog::break_away_test
