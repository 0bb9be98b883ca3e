#include "method/hysteresis/steady_loop.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::steady_loop_test {
namespace {

constexpr double centre = -0.3880191234;
constexpr double amplitude = 3e-5;
constexpr double frequency = 0.7;

/// An ellipse 2e-5 rad and 0.4 N·m wide and high about (centre, 3.9), after a cycle of something
/// else, with noise.
method::hysteresis::LoopTrace ellipse(double noise, double cycles) {
  method::hysteresis::LoopTrace trace;
  statistics::RandomStream random(1, 1);
  for (int i = 0; i < static_cast<int>(cycles * 1000 / frequency); ++i) {
    const double t = 1e-3 * i;
    const double phase = 2 * std::numbers::pi * frequency * t;
    const bool is_start_up = t * frequency < 1;
    trace.t_s.push_back(t);
    trace.q_rad.push_back(centre + amplitude * std::sin(phase));
    trace.torque_Nm.push_back((is_start_up ? 9.0 : 3.9 + 0.2 * std::cos(phase)) +
                              noise * random.normal());
  }
  return trace;
}

method::hysteresis::Oscillation oscillation(double steady_cycles) {
  return {centre, amplitude, frequency, steady_cycles + 1, steady_cycles, 0, false};
}

TEST(SteadyLoop, IsTheMeanOfTheSteadyCycles) {
  const auto loop = method::hysteresis::steady_loop(ellipse(0.02, 11), oscillation(10), 200);
  ASSERT_TRUE(loop);
  ASSERT_EQ(loop->torque_Nm.size(), 200U);
  EXPECT_EQ(loop->centre_rad, centre);
  for (std::size_t k = 0; k < 200; ++k) {
    const double x = loop->from_centre_rad[k] / amplitude;
    const double y = (loop->torque_Nm[k] - 3.9) / 0.2;
    // 71 samples of a bin: 0.02 / sqrt(71) / 0.2 is 0.012; five of it.
    EXPECT_NEAR(x * x + y * y, 1, 0.13) << k;
  }
}

TEST(SteadyLoop, IsThinnedOutWhereNothingRepeats) {
  const method::hysteresis::LoopTrace trace = ellipse(0, 1.99);
  const auto loop = method::hysteresis::steady_loop(trace, oscillation(0), 50);
  ASSERT_TRUE(loop);
  EXPECT_LE(loop->torque_Nm.size(), 50U);
  EXPECT_GE(loop->torque_Nm.size(), 40U);
}

TEST(SteadyLoop, NeedsALoop) {
  EXPECT_FALSE(method::hysteresis::steady_loop({}, oscillation(5), 200));
  method::hysteresis::LoopTrace still = ellipse(0, 3);
  for (double& t : still.t_s) t = 1;
  EXPECT_FALSE(method::hysteresis::steady_loop(still, oscillation(2), 200));
  method::hysteresis::Oscillation no_period = oscillation(2);
  no_period.frequency_Hz = 0;
  EXPECT_FALSE(method::hysteresis::steady_loop(ellipse(0, 3), no_period, 200));
}

TEST(SteadyLoop, HasNoEmptyBinsWhereSamplesAreFew) {
  method::hysteresis::LoopTrace coarse;
  const method::hysteresis::LoopTrace fine = ellipse(0, 6);
  for (std::size_t i = 0; i < fine.t_s.size(); i += 37) {
    coarse.t_s.push_back(fine.t_s[i]);
    coarse.q_rad.push_back(fine.q_rad[i]);
    coarse.torque_Nm.push_back(fine.torque_Nm[i]);
  }
  const auto loop = method::hysteresis::steady_loop(coarse, oscillation(5), 200);
  ASSERT_TRUE(loop);
  EXPECT_GE(loop->torque_Nm.size(), 36U);
  EXPECT_LE(loop->torque_Nm.size(), 40U);
}

}  // namespace
}  // namespace tribolog::steady_loop_test
