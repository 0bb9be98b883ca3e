// Ripple within a loop is taken off by the phase of the sweep, and the loop's mean stays.

#include "method/hysteresis/loop_widening.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace tribolog::loop_widening_test {
namespace {

constexpr double gear_ratio = 50;

joint::Recording loop() {
  joint::Recording r;
  for (int i = 0; i < 2000; ++i) {
    const double phase = 0.02 * i;
    r.t_s.push_back(0.001 * i);
    r.q_rad.push_back(0.1 + 0.02 * std::sin(phase));
    r.torque_Nm.push_back(2 + 0.5 * std::cos(phase));
  }
  return r;
}

method::gravity::CogSweepResult sweep_with_ripple(double amplitude_Nm) {
  method::gravity::CogSweepResult sweep;
  sweep.found = true;
  sweep.lowest_rad = -1;
  sweep.highest_rad = 1;
  sweep.ripple.lines.push_back({6, amplitude_Nm, 0.7});
  return sweep;
}

double mean_of(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

TEST(LoopWidening, RippleWithinTheLoopIsTakenOffAndItsMeanStays) {
  const joint::Recording plain = loop();
  const method::gravity::CogSweepResult sweep = sweep_with_ripple(0.1);
  joint::Recording rippled = plain;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    rippled.torque_Nm[i] += sweep.ripple.torque_Nm(gear_ratio * plain.q_rad[i]);
  }
  const double mean = mean_of(rippled.torque_Nm);
  method::hysteresis::subtract_ripple_from_loop(sweep, gear_ratio, rippled);
  EXPECT_NEAR(mean_of(rippled.torque_Nm), mean, 1e-12);
  const double moved = mean - mean_of(plain.torque_Nm);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    ASSERT_NEAR(rippled.torque_Nm[i] - moved, plain.torque_Nm[i], 1e-12);
  }
}

TEST(LoopWidening, ALoopOutsideTheSweepOrWithoutRippleStaysAsItIs) {
  const joint::Recording plain = loop();
  method::gravity::CogSweepResult sweep = sweep_with_ripple(0.1);
  sweep.highest_rad = 0.1;
  joint::Recording r = plain;
  method::hysteresis::subtract_ripple_from_loop(sweep, gear_ratio, r);
  EXPECT_EQ(r.torque_Nm, plain.torque_Nm);
  method::hysteresis::subtract_ripple_from_loop(sweep_with_ripple(1e-5), gear_ratio, r);
  EXPECT_EQ(r.torque_Nm, plain.torque_Nm);
}

method::hysteresis::LuGreFit fit_of(method::hysteresis::LuGreParameterName name, double value,
                                    double half_width) {
  method::hysteresis::LuGreFit fit;
  method::hysteresis::LuGreParameter stiffness;
  stiffness.name = method::hysteresis::LuGreParameterName::bristle_stiffness;
  stiffness.estimate = statistics::symmetric_estimate(200, 1);
  method::hysteresis::LuGreParameter other;
  other.name = name;
  other.estimate = statistics::symmetric_estimate(value, half_width);
  fit.parameters = {stiffness, other};
  return fit;
}

TEST(LoopWidening, StaticTorqueIsReferredToTheRunsAndTheBristleToTheTorquesGain) {
  using method::hysteresis::LuGreParameterName;
  const auto fit = method::hysteresis::with_friction_of_runs(
      fit_of(LuGreParameterName::static_torque, 0.9, 0.009),
      statistics::symmetric_estimate(0.2, 0.012), statistics::symmetric_estimate(0.04, 0.005));
  const statistics::Estimate level = *fit.shown(LuGreParameterName::static_torque);
  EXPECT_NEAR(level.value, 0.75, 1e-12);
  EXPECT_NEAR(level.half_width() / level.value, std::hypot(0.01, 0.01), 1e-12);
  const statistics::Estimate stiffness = *fit.shown(LuGreParameterName::bristle_stiffness);
  EXPECT_NEAR(stiffness.value, 200 / 1.04, 1e-9);
  EXPECT_NEAR(stiffness.half_width() / stiffness.value, std::hypot(0.005, 0.005 / 1.04), 1e-9);
  EXPECT_EQ(stiffness.method.code().text(), "interval.at_the_gain");
}

/// Of friction that differs by nine tenths, or by none, a tenfold torque would be made.
TEST(LoopWidening, WhatIsTooLittleKnownOfTheRunsOnlyWidens) {
  const statistics::Estimate level = method::hysteresis::at_the_runs(
      statistics::symmetric_estimate(5, 0.1), statistics::symmetric_estimate(-0.9, 0.5));
  EXPECT_EQ(level.value, 5);
  EXPECT_NEAR(level.half_width(), std::hypot(0.1, 5 * 1.4), 1e-12);
}

}  // namespace
}  // namespace tribolog::loop_widening_test
