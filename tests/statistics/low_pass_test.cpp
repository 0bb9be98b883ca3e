// The first-order low pass, against what its differential equation gives, and the moving mean,
// against its integral.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/sampled_signal.h"

namespace tribolog::low_pass_test {
namespace {

TEST(LowPass, OfARampLagsByTheTimeConstantHoweverCoarseTheSampling) {
  for (const double time_constant : {0.3, 2.0, 40.0}) {
    std::vector<double> ramp;
    for (int i = 0; i < 2000; ++i) ramp.push_back(0.5 * i);
    statistics::low_pass(ramp, time_constant);
    // Exact from the first sample on: 1 - exp(-t / tau) of the lag is there at once.
    for (const int i : {0, 1, 7, 1999}) {
      const double lag = time_constant * (1 - std::exp(-i / time_constant));
      EXPECT_NEAR(ramp[static_cast<std::size_t>(i)], 0.5 * (i - lag), 1e-9) << time_constant;
    }
  }
}

TEST(LowPass, OfNoTimeConstantLeavesTheSignal) {
  std::vector<double> signal{1, -2, 3};
  statistics::low_pass(signal, 0);
  EXPECT_EQ(signal, (std::vector<double>{1, -2, 3}));
}

TEST(MovingMean, OfARampLagsByHalfTheWindowHoweverCoarseTheSampling) {
  for (const double width : {0.4, 3.0, 25.5}) {
    std::vector<double> ramp;
    for (int i = 0; i < 200; ++i) ramp.push_back(7 + 0.5 * i);
    statistics::moving_mean(ramp, width);
    EXPECT_DOUBLE_EQ(ramp.front(), 7);
    for (const int i : {26, 27, 199}) {
      EXPECT_NEAR(ramp[static_cast<std::size_t>(i)], 7 + 0.5 * (i - width / 2), 1e-9) << width;
    }
    // Before the ramp began the signal stood: the mean of t^2 / 2 over the window.
    const double risen = std::max(10 - width, 0.0);
    const double area = (10 * 10 - risen * risen) / 2;
    EXPECT_NEAR(ramp[10], 7 + 0.5 * area / width, 1e-9) << width;
  }
}

TEST(MovingMean, OverWholePeriodsIsTheMean) {
  std::vector<double> wave;
  for (int i = 0; i < 400; ++i) wave.push_back(2 + std::sin(2 * std::numbers::pi * i / 20));
  statistics::moving_mean(wave, 40);
  for (std::size_t i = 40; i < wave.size(); ++i) EXPECT_NEAR(wave[i], 2, 1e-9);
  std::vector<double> same{1, -2, 3};
  statistics::moving_mean(same, 0);
  EXPECT_EQ(same, (std::vector<double>{1, -2, 3}));
}

}  // namespace
}  // namespace tribolog::low_pass_test
