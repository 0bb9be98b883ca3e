// What a filter or a mean leaves of a torque whose lag was taken off, against closed forms and
// against the same done sample by sample.

#include "method/motion/torque_rounding.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "method/motion/torque_lag.h"
#include "statistics/sampled_signal.h"

namespace tribolog::torque_rounding_test {
namespace {

using method::motion::LagShape;
using method::motion::TorqueRounding;

constexpr double interval_s = 1e-3;

std::vector<double> times(std::size_t count) {
  std::vector<double> t;
  for (std::size_t i = 0; i < count; ++i) t.push_back(interval_s * static_cast<double>(i));
  return t;
}

/// A friction that turns round.
Eigen::VectorXd steps(const std::vector<double>& t) {
  Eigen::VectorXd out(static_cast<Eigen::Index>(t.size()));
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    out(i) = std::tanh(40 * std::sin(2 * std::numbers::pi * t[static_cast<std::size_t>(i)]));
  }
  return out;
}

TEST(TorqueRounding, IsWhatAFilterOrAMeanLeavesOnceTheLagIsTakenOff) {
  constexpr double lag_s = 12e-3;  // whole samples: taking it off interpolates nothing
  const std::vector<double> t = times(3000);
  for (const LagShape shape : {LagShape::filter, LagShape::moving_mean}) {
    joint::Recording logged;
    logged.t_s = t;
    logged.q_rad.assign(t.size(), 0.0);
    const Eigen::VectorXd torque = steps(t);
    logged.torque_Nm.assign(torque.data(), torque.data() + torque.size());
    if (shape == LagShape::filter) {
      statistics::low_pass(logged.torque_Nm, lag_s / interval_s);
    } else {
      statistics::moving_mean(logged.torque_Nm, 2 * lag_s / interval_s);
    }
    const joint::Recording moved_back = method::motion::aligned(logged, lag_s);
    Eigen::VectorXd rounded = torque;
    TorqueRounding{shape, lag_s}.apply(t, rounded);
    for (std::size_t i = 200; i + 200 < moved_back.size(); ++i) {
      ASSERT_NEAR(moved_back.torque_Nm[i], rounded(static_cast<Eigen::Index>(i)), 1e-9)
          << to_string(shape) << " " << i;
    }
  }
}

TEST(TorqueRounding, OfAStraightLineOrOfADelayIsNothing) {
  const std::vector<double> t = times(1000);
  Eigen::VectorXd line(static_cast<Eigen::Index>(t.size()));
  for (Eigen::Index i = 0; i < line.size(); ++i) line(i) = 3 - 0.25 * static_cast<double>(i);
  for (const LagShape shape : {LagShape::filter, LagShape::moving_mean}) {
    Eigen::VectorXd rounded = line;
    TorqueRounding{shape, 5e-3}.apply(t, rounded);
    EXPECT_LT((rounded - line).segment(100, 800).cwiseAbs().maxCoeff(), 1e-6) << to_string(shape);
  }
  for (const TorqueRounding none : {TorqueRounding{LagShape::delay, 5e-3}, TorqueRounding{},
                                    TorqueRounding{LagShape::elastic_gear, 5e-3}}) {
    EXPECT_FALSE(none.any());
    Eigen::VectorXd same = steps(t);
    none.apply(t, same);
    EXPECT_EQ(same, steps(t));
  }
}

TEST(TorqueRounding, TakesTheSizeOfAWaveThatItsTransformSays) {
  constexpr double frequency_Hz = 7;
  constexpr double size_s = 10e-3;
  const double phase = 2 * std::numbers::pi * frequency_Hz * size_s;
  const std::vector<double> t = times(4000);
  Eigen::VectorXd wave(static_cast<Eigen::Index>(t.size()));
  for (Eigen::Index i = 0; i < wave.size(); ++i) {
    wave(i) = std::sin(2 * std::numbers::pi * frequency_Hz * t[static_cast<std::size_t>(i)]);
  }
  const auto size_behind = [&](LagShape shape) {
    Eigen::VectorXd rounded = wave;
    TorqueRounding{shape, size_s}.apply(t, rounded);
    return std::sqrt(2 * rounded.segment(1000, 2000).squaredNorm() / 2000);
  };
  EXPECT_NEAR(size_behind(LagShape::moving_mean), std::sin(phase) / phase, 1e-3);
  EXPECT_NEAR(size_behind(LagShape::filter), 1 / std::sqrt(1 + phase * phase), 1e-3);
}

}  // namespace
}  // namespace tribolog::torque_rounding_test
