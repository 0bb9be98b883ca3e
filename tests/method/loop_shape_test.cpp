// Closed forms of a LuGre contact: its loop closes, turns over at a known slope, and dissipates.

#include "method/hysteresis/loop_shape.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/paper_joint.h"

namespace tribolog::loop_shape_test {
namespace {

/// A LuGre joint without damping at micro-speed, swinging far beyond its pre-sliding range, so that
/// it turns from sliding.
simulate::Scenario wide_loop() {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.constant_speed.reset();
  s.motor_inertia_kgm2 = 0;
  s.arm_inertia_kgm2 = 0;
  s.presliding = std::make_shared<friction::LuGreFriction>(
      friction::LuGreFriction::Parameters{465.0, 0.0, 0.0, 0.88, 0.88, 5.0});
  s.oscillation->amplitude_rad = 20 * 0.88 / 465 / s.gear_ratio;
  s.oscillation->frequency_Hz = 0.5;
  s.oscillation->cycles = 8;
  return s;
}

TEST(LoopShape, StiffnessBehindAReversalIsThatOfTheContact) {
  const simulate::Scenario s = wide_loop();
  const joint::Dataset d = simulate::simulated_dataset(s);
  const auto shapes =
      method::hysteresis::describe_loops(d.with_role(joint::Role::oscillation), s.gear_ratio);
  ASSERT_EQ(shapes.size(), 1U);
  const method::hysteresis::LoopShape& shape = shapes.front();
  // z = g (1 - 2 exp(-x/g)) behind the reversal: a third of its height 2 g is turned over at
  // x = g ln 1.5. Motor torque per joint angle: n s0. The regression lies a little above that
  // secant.
  const double secant = 2.0 / 3 / std::log(1.5) * 465 * s.gear_ratio;
  ASSERT_TRUE(shape.stiffness_Nm_rad);
  EXPECT_NEAR(shape.stiffness_Nm_rad->value / secant, 1, 0.04);
  EXPECT_NEAR(shape.width_rad, 2 * s.oscillation->amplitude_rad, 1e-9);
  EXPECT_GT(shape.strokes, 10U);
}

TEST(LoopShape, SteadyLoopClosesAndDissipatesWhatFrictionDoes) {
  const simulate::Scenario s = wide_loop();
  const joint::Dataset d = simulate::simulated_dataset(s);
  const method::hysteresis::LoopShape shape =
      method::hysteresis::describe_loops(d.with_role(joint::Role::oscillation), s.gear_ratio)
          .front();
  EXPECT_TRUE(shape.closes);
  EXPECT_LT(shape.closing_gap, 1e-6);
  // Each stroke of length X at |T| = Ts loses 2 g Ts (1 - exp(-X/g)) of Ts X to turning over.
  const double stroke = 2 * s.gear_ratio * s.oscillation->amplitude_rad;
  const double g = 0.88 / 465;
  const double work = 2 * 0.88 * (stroke - 2 * g * (1 - std::exp(-stroke / g)));
  EXPECT_NEAR(shape.dissipated_J / work, 1, 1e-3);
}

TEST(LoopShape, ALoopThatWandersIsNotClosed) {
  joint::Dataset d = simulate::simulated_dataset(wide_loop());
  joint::Recording& r = d.recordings.front();
  const double period = 2;
  for (std::size_t i = 0; i < r.size(); ++i) {
    r.q_rad[i] += 0.1 * 2 * wide_loop().oscillation->amplitude_rad * r.t_s[i] / period;
  }
  const method::hysteresis::LoopShape shape =
      method::hysteresis::describe_loops(d.with_role(joint::Role::oscillation), 100).front();
  EXPECT_FALSE(shape.closes);
  EXPECT_NEAR(shape.closing_gap, 0.1 / 1.7, 0.02);  // the width grows with the wandering
}

TEST(LoopShape, StiffnessSurvivesEncoderStepsAndNoise) {
  simulate::Scenario s = wide_loop();
  s.oscillation->amplitude_rad = 1e-4;
  s.oscillation->frequency_Hz = 1;
  s.oscillation->cycles = 10;
  const auto clean = method::hysteresis::describe_loops(
                         simulate::simulated_dataset(s).with_role(joint::Role::oscillation), 100)
                         .front();
  s.noise = test::noisy_paper_joint(3).noise;
  const auto noisy = method::hysteresis::describe_loops(
                         simulate::simulated_dataset(s).with_role(joint::Role::oscillation), 100)
                         .front();
  ASSERT_TRUE(noisy.stiffness_Nm_rad && clean.stiffness_Nm_rad);
  EXPECT_NEAR(noisy.stiffness_Nm_rad->value / clean.stiffness_Nm_rad->value, 1, 0.05);
}

TEST(LoopShape, LeavesOutWhatDoesNotSwing) {
  joint::Recording still;
  for (int i = 0; i < 1000; ++i) {
    still.t_s.push_back(1e-3 * i);
    still.q_rad.push_back(0.1);
    still.torque_Nm.push_back(1.0);
  }
  EXPECT_TRUE(method::hysteresis::describe_loops({&still}, 100).empty());
  EXPECT_TRUE(method::hysteresis::describe_loops({}, 100).empty());
}

}  // namespace
}  // namespace tribolog::loop_shape_test
