// The first-order low pass, against what its differential equation gives.

#include <cmath>
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

}  // namespace
}  // namespace tribolog::low_pass_test
