// The lag that is taken off the loops' torque, and what a filter in place of a delay leaves.

#include "method/hysteresis/loop_timing.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "statistics/sampled_signal.h"

namespace tribolog::loop_timing_test {
namespace {

constexpr double interval_s = 1e-3;

/// A friction that turns round, logged `late_s` later than its angle.
joint::Recording loop(double late_s) {
  joint::Recording r;
  for (int i = 0; i < 3000; ++i) {
    const double t = interval_s * i;
    r.t_s.push_back(t);
    r.q_rad.push_back(std::sin(2 * std::numbers::pi * t));
    r.torque_Nm.push_back(std::tanh(40 * std::sin(2 * std::numbers::pi * (t - late_s))));
  }
  return r;
}

TEST(LoopTiming, TakesOffALagThatIsBeyondDoubtAndLeavesAnother) {
  using method::hysteresis::timing_of_loops;
  EXPECT_EQ(timing_of_loops({}).half_width_s, 0) << "stated to be none";
  const auto open = timing_of_loops(statistics::Estimate{1e-3, -1e-3, 3e-3, {}});
  EXPECT_EQ(open.lag_s, 0);
  EXPECT_EQ(open.half_width_s, 2e-3);
  for (const double sign : {1.0, -1.0}) {
    const auto clear = timing_of_loops(statistics::symmetric_estimate(sign * 5e-3, 1e-3));
    EXPECT_EQ(clear.lag_s, sign * 5e-3);
    EXPECT_EQ(clear.half_width_s, 1e-3);
  }
}

TEST(LoopTiming, AlignedATorqueStandsBesideItsAngle) {
  for (const double late_s : {7e-3, -7e-3, 2.5e-3}) {
    const joint::Recording logged = loop(late_s);
    const joint::Recording moved = method::hysteresis::aligned(logged, late_s);
    ASSERT_GT(moved.size(), logged.size() - 10);
    ASSERT_LT(moved.size(), logged.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const double truth = std::tanh(40 * moved.q_rad[i]);
      // Between samples the torque is a straight line.
      ASSERT_NEAR(moved.torque_Nm[i], truth, 0.02) << late_s << " " << i;
    }
  }
  const joint::Recording as_it_is = loop(0);
  EXPECT_EQ(method::hysteresis::aligned(as_it_is, 0).torque_Nm, as_it_is.torque_Nm);
}

TEST(LoopTiming, AFilterLeavesWhatItRoundsOnceItsLagIsTakenOff) {
  constexpr double lag_s = 12e-3;  // whole samples: taking it off interpolates nothing
  const joint::Recording plain = loop(0);
  joint::Recording logged = plain;
  statistics::low_pass(logged.torque_Nm, lag_s / interval_s);
  const joint::Recording moved = method::hysteresis::aligned(logged, lag_s);
  const Eigen::VectorXd torque = Eigen::Map<const Eigen::VectorXd>(
      plain.torque_Nm.data(), static_cast<Eigen::Index>(plain.size()));
  const Eigen::VectorXd rounded = method::hysteresis::rounded_by_filter(plain.t_s, torque, lag_s);
  EXPECT_GT((rounded - torque).cwiseAbs().maxCoeff(), 0.1);
  for (std::size_t i = 200; i + 200 < moved.size(); ++i) {
    ASSERT_NEAR(moved.torque_Nm[i], rounded(static_cast<Eigen::Index>(i)), 1e-9) << i;
  }
}

}  // namespace
}  // namespace tribolog::loop_timing_test
