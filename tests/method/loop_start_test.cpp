// Where the blow of a starting drive ends, and that nothing else is taken for one.

#include "method/hysteresis/loop_start.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::loop_start_test {
namespace {

constexpr double period_s = 0.5;

/// @param blow of the drive, in heights of the loop, that dies away within some 20 ms.
joint::Recording loop(double blow, double duration_s = 5) {
  statistics::RandomStream random(3, 2);
  joint::Recording r;
  for (int i = 0; i < static_cast<int>(duration_s * 1000); ++i) {
    const double t = i * 1e-3;
    const double virgin = 1 - std::exp(-t / 0.02);
    r.t_s.push_back(20 + t);
    r.q_rad.push_back(std::sin(2 * M_PI * t / period_s));
    r.torque_Nm.push_back(4 + virgin * std::tanh(8 * std::cos(2 * M_PI * t / period_s)) +
                          2 * blow * std::exp(-t / 0.02) + 0.02 * random.normal());
  }
  return r;
}

TEST(LoopStart, ASteadyLoopHasNone) {
  EXPECT_EQ(method::hysteresis::settled_from_s(loop(0), period_s), 0);
}

TEST(LoopStart, EndsWhereTheBlowHasDiedAway) {
  const double from = method::hysteresis::settled_from_s(loop(3), period_s);
  EXPECT_GT(from, 0.06);  // 5 % of it are left at three time constants
  EXPECT_LT(from, 0.2);
  EXPECT_LT(method::hysteresis::settled_from_s(loop(0.6), period_s), from);
}

TEST(LoopStart, OfLessThanThreeCyclesNothingIsKnown) {
  EXPECT_EQ(method::hysteresis::settled_from_s(loop(3, 1.2), period_s), 0);
}

TEST(LoopStart, ALaterJumpIsNone) {
  joint::Recording r = loop(0);
  for (std::size_t i = 2000; i < 2010; ++i) r.torque_Nm[i] += 5;
  EXPECT_EQ(method::hysteresis::settled_from_s(r, period_s), 0);
}

}  // namespace
}  // namespace tribolog::loop_start_test
