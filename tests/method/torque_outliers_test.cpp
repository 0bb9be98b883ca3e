// Spikes laid on a torque must be found, and nothing else.

#include "method/motion/torque_outliers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::torque_outliers_test {
namespace {

/// A loop that turns round twice a second, with noise.
joint::Recording loop(double noise_Nm) {
  statistics::RandomStream random(7, 1);
  joint::Recording r;
  r.name = "loop.csv";
  for (int i = 0; i < 2000; ++i) {
    const double t = i * 0.002;
    const double phase = std::fmod(t, 1.0);
    r.t_s.push_back(t);
    r.q_rad.push_back(std::sin(2 * M_PI * t));
    const double friction = std::cos(2 * M_PI * t) > 0 ? 1.0 : -1.0;  // a step at each reversal
    r.torque_Nm.push_back(3 + friction + 0.3 * phase + noise_Nm * random.normal());
  }
  return r;
}

TEST(TorqueOutliers, AStepOfFrictionAndNoiseAreNone) {
  for (const double noise : {0.0, 0.01, 0.2}) {
    EXPECT_TRUE(method::motion::torque_outliers(loop(noise)).empty()) << noise;
  }
}

TEST(TorqueOutliers, SpikesAreReplacedByTheLineBetweenTheirNeighboursAndCounted) {
  const joint::Recording clean = loop(0.01);
  std::vector<joint::Recording> spiked{clean, clean};
  for (const std::size_t i : {100UL, 777UL, 778UL, 1400UL}) spiked[1].torque_Nm[i] += 2;
  const auto found = method::motion::replace_torque_outliers(spiked);
  EXPECT_EQ(found.replaced, 4U);
  EXPECT_EQ(found.recording, "loop.csv");
  EXPECT_NEAR(found.worst_percent, 0.2, 1e-9);
  EXPECT_NEAR(found.largest_Nm, 2, 0.1);
  for (std::size_t i = 0; i < clean.size(); ++i) {
    EXPECT_NEAR(spiked[1].torque_Nm[i], clean.torque_Nm[i], 0.06) << i;
  }
}

TEST(TorqueOutliers, SpikesAreFoundInASteadyMotionWhoseAnglesAreRounded) {
  constexpr double step = 1e-4;
  joint::Recording r = loop(0.01);
  for (std::size_t i = 0; i < r.size(); ++i) {
    r.q_rad[i] = step * std::round(0.003 * r.t_s[i] / step);  // most angles equal their neighbours
  }
  for (std::size_t i = 20; i < r.size(); i += 97) r.torque_Nm[i] += 2;
  EXPECT_EQ(method::motion::torque_outliers(r).size(), 21U);
}

TEST(TorqueOutliers, ALogThatConsistsOfSpikesIsLeftAsItIs) {
  joint::Recording r = loop(0.01);
  for (std::size_t i = 0; i < r.size(); i += 5) r.torque_Nm[i] += 2;
  EXPECT_TRUE(method::motion::torque_outliers(r).empty());
}

TEST(TorqueOutliers, ATorqueThatSpeedsTheJointUpIsNone) {
  joint::Recording r = loop(0.01);
  for (std::size_t i = 0; i < r.size(); ++i) r.q_rad[i] = i < 1000 ? 0 : 1e-3 * (i - 1000.0);
  r.torque_Nm[1000] += 2;
  EXPECT_TRUE(method::motion::torque_outliers(r).empty());
}

}  // namespace
}  // namespace tribolog::torque_outliers_test
