// Gravity from runs at constant speed: found again from simulated joints, and refused where the way
// is too short.

#include "method/gravity/run_gravity.h"

#include <cmath>

#include <gtest/gtest.h>

#include "joint/dataset.h"
#include "statistics/random_stream.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::run_gravity_test {
namespace {

constexpr double gravity_Nm = 40.0;
constexpr double q_peak_rad = 1.5;
constexpr double gear_ratio = 5.0;

/// A run of 400 samples with offset, gravity, a ripple that repeats with the angle, and noise.
joint::Recording run(double from, double to, double offset_Nm, double ripple_Nm, double noise_Nm,
                     statistics::RandomStream& random) {
  joint::Recording r;
  r.role = joint::Role::constant_speed;
  for (int i = 0; i < 400; ++i) {
    r.t_s.push_back(0.01 * i);
    const double q = from + (to - from) * i / 399.0;
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(offset_Nm + gravity_Nm * std::cos(q - q_peak_rad) +
                          ripple_Nm * std::sin(9 * q) + noise_Nm * random.normal());
  }
  return r;
}

method::gravity::RunGravityResult identify(const std::vector<joint::Recording>& runs) {
  std::vector<const joint::Recording*> all;
  for (const joint::Recording& r : runs) all.push_back(&r);
  return method::gravity::identify_run_gravity(all, gear_ratio);
}

TEST(RunGravity, IsExactWithoutNoise) {
  statistics::RandomStream random(1, 0);
  const method::gravity::RunGravityResult g =
      identify({run(0, 2, 12, 0, 0, random), run(0.2, 1.5, 13, 0, 0, random),
                run(0, -2, -11, 0, 0, random)});
  ASSERT_TRUE(g.found) << wording::words(g.reason);
  EXPECT_NEAR(g.gravity_Nm.value, gravity_Nm, 1e-3);
  EXPECT_NEAR(g.q_peak_rad.value, q_peak_rad, 1e-4);
  EXPECT_EQ(g.runs_used, 3U);
}

// Ripple repeats with the angle: more runs over the same angles must not narrow the interval.
TEST(RunGravity, RepeatingTheSameWayDoesNotAverageTheRippleOut) {
  statistics::RandomStream random(2, 0);
  std::vector<joint::Recording> few;
  std::vector<joint::Recording> many;
  for (int k = 0; k < 8; ++k) few.push_back(run(-1, 2, 10 + k, 2, 0.1, random));
  for (int k = 0; k < 32; ++k) many.push_back(run(-1, 2, 10 + k, 2, 0.1, random));
  const double half_of_few = identify(few).gravity_Nm.half_width();
  const double half_of_many = identify(many).gravity_Nm.half_width();
  EXPECT_GT(half_of_many, 0.8 * half_of_few);
  EXPECT_NEAR(identify(many).gravity_Nm.value, gravity_Nm, half_of_many);
}

// 100 seeds, each with a ripple of other phase: the whole curve is turned against it.
TEST(RunGravity, TheIntervalCoversUnderRipple) {
  constexpr int seeds = 100;
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    statistics::RandomStream random(seed, 0);
    std::vector<joint::Recording> runs;
    const double phase = 0.063 * static_cast<double>(seed);
    for (int k = 0; k < 10; ++k) {
      runs.push_back(run(-1, 2, 10 + k, 0, 0.3, random));
      for (std::size_t i = 0; i < runs.back().size(); ++i) {
        runs.back().torque_Nm[i] += std::sin(14 * runs.back().q_rad[i] + phase);
      }
    }
    const method::gravity::RunGravityResult g = identify(runs);
    ASSERT_TRUE(g.found);
    covered += g.gravity_Nm.low <= gravity_Nm && gravity_Nm <= g.gravity_Nm.high;
  }
  RecordProperty("covered", covered);
  EXPECT_GE(covered, 88);
}

TEST(RunGravity, SaysWhetherTheLoadEverDrives) {
  statistics::RandomStream random(3, 0);
  const double up = q_peak_rad - 1.4;
  const double down = q_peak_rad + 1.4;
  EXPECT_TRUE(identify({run(up, down, 12, 0, 0.1, random), run(up, down, 13, 0, 0.1, random)})
                  .always_lifts);
  EXPECT_FALSE(identify({run(up, down, 12, 0, 0.1, random), run(down, up, -12, 0, 0.1, random)})
                   .always_lifts);
}

TEST(RunGravity, ShortWaysAndNoGravityAreRefusedInWords) {
  statistics::RandomStream random(4, 0);
  const method::gravity::RunGravityResult none = identify({});
  EXPECT_FALSE(none.found);
  EXPECT_FALSE(none.reason.empty());
  const method::gravity::RunGravityResult brief = identify({run(0, 0.02, 12, 0, 0.1, random)});
  EXPECT_FALSE(brief.found);
  EXPECT_NE(wording::words(brief.reason).find("travels far enough"), std::string::npos)
      << wording::words(brief.reason);
  joint::Recording flat = run(0, 2, 12, 0, 0, random);
  for (double& torque : flat.torque_Nm) torque = 12 + 0.1 * random.normal();
  const method::gravity::RunGravityResult weightless =
      identify({flat, flat, flat, flat, flat, flat, flat, flat});
  EXPECT_FALSE(weightless.found);
  EXPECT_NE(wording::words(weightless.reason).find("do not show gravity"), std::string::npos)
      << wording::words(weightless.reason);
}

TEST(RunGravity, SimulatedJointGivesTheSameAsItsSweep) {
  simulate::Scenario s = test::paper_joint();
  const joint::Dataset d = simulate::simulated_dataset(s);
  const method::gravity::RunGravityResult g =
      method::gravity::identify_run_gravity(d.with_role(joint::Role::constant_speed), s.gear_ratio);
  ASSERT_TRUE(g.found) << wording::words(g.reason);
  EXPECT_NEAR(g.gravity_Nm.value / test::true_gravity_Nm, 1, 1e-3);
  EXPECT_NEAR(g.q_peak_rad.value, test::true_q_peak_rad(), 1e-3);
}

}  // namespace
}  // namespace tribolog::run_gravity_test
