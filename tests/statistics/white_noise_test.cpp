// White noise is told from what is slow beside it, and from jumps.

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"
#include "statistics/sampled_signal.h"

namespace tribolog::white_noise_test {
namespace {

TEST(WhiteNoise, AParabolaHasNone) {
  std::vector<double> parabola;
  for (int i = 0; i < 50; ++i) parabola.push_back(3.0 - 2.0 * i + 0.5 * i * i);
  const std::vector<double> third = statistics::third_differences(parabola);
  EXPECT_EQ(third.size(), parabola.size() - 3);
  EXPECT_NEAR(statistics::white_variance(third), 0, 1e-20);
  EXPECT_NEAR(statistics::white_sd_beside_jumps(third), 0, 1e-10);
}

TEST(WhiteNoise, BothWaysFindTheNoiseOfAPureOne) {
  statistics::RandomStream random(3, 0);
  std::vector<double> signal;
  for (int i = 0; i < 40000; ++i) signal.push_back(5 * std::sin(1e-3 * i) + 0.3 * random.normal());
  const std::vector<double> third = statistics::third_differences(signal);
  // Four standard errors of a scatter seen by 40,000 samples that share neighbours.
  EXPECT_NEAR(std::sqrt(statistics::white_variance(third)), 0.3, 0.009);
  EXPECT_NEAR(statistics::white_sd_beside_jumps(third), 0.3, 0.009);
}

TEST(WhiteNoise, JumpsWeighOnTheMeanSquareOnly) {
  statistics::RandomStream random(4, 0);
  std::vector<double> signal;
  for (int i = 0; i < 40000; ++i) signal.push_back((i / 4000) % 2 * 50.0 + 0.3 * random.normal());
  const std::vector<double> third = statistics::third_differences(signal);
  EXPECT_GT(std::sqrt(statistics::white_variance(third)), 0.5);
  EXPECT_NEAR(statistics::white_sd_beside_jumps(third), 0.3, 0.009);
}

TEST(WhiteNoise, OfTooFewSamplesThereIsNone) {
  EXPECT_TRUE(statistics::third_differences({1, 2, 3}).empty());
  EXPECT_EQ(statistics::white_variance({}), 0);
  EXPECT_EQ(statistics::white_sd_beside_jumps({}), 0);
}

}  // namespace
}  // namespace tribolog::white_noise_test
