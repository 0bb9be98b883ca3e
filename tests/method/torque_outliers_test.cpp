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

// Bytes that were read wrongly: no motion makes such torques, so none excuses them.
TEST(TorqueOutliers, ImpossibleSpikesAreReplacedAtEndsAndReversalsToo) {
  const joint::Recording clean = loop(0.01);
  const std::size_t last = clean.size() - 1;
  // Its usual range is 2.3 N·m; at 125 and 375 it turns round.
  for (const double spike_Nm : {50.0, -1e4}) {
    std::vector<joint::Recording> spiked{clean};
    const std::vector<std::size_t> places{0, 1, 125, 375, 900, last - 1, last};
    for (const std::size_t i : places) spiked[0].torque_Nm[i] += spike_Nm;
    EXPECT_EQ(method::motion::torque_outliers(spiked[0]), places);
    const auto found = method::motion::replace_torque_outliers(spiked);
    EXPECT_EQ(found.replaced, places.size());
    EXPECT_NEAR(found.largest_Nm, std::abs(spike_Nm), 1.2);
    for (std::size_t i = 0; i < clean.size(); ++i) {
      // Beside a step of friction the line between the neighbours is half of it off.
      EXPECT_NEAR(spiked[0].torque_Nm[i], clean.torque_Nm[i], i == 125 || i == 375 ? 2.1 : 0.06)
          << i;
    }
    EXPECT_EQ(spiked[0].torque_Nm[0], clean.torque_Nm[2]) << "one neighbour alone";
    EXPECT_EQ(spiked[0].torque_Nm[last], clean.torque_Nm[last - 2]);
  }
}

TEST(TorqueOutliers, ASpikeThatAMotionMayMakeStandsAtARecordingsEnd) {
  joint::Recording r = loop(0.01);
  r.torque_Nm.back() += 3;
  EXPECT_TRUE(method::motion::torque_outliers(r).empty());
}

/// A run's torque hardly varies; where it starts, all of it is new, where it reverses, twice.
TEST(TorqueOutliers, StartAndEndOfARunAtConstantSpeedAreNone) {
  for (const std::size_t samples : {40UL, 2000UL}) {
    joint::Recording r = loop(0);
    for (std::size_t i = 0; i < r.size(); ++i) {
      r.q_rad[i] = 0.5 * r.t_s[i];
      r.torque_Nm[i] = 1.2 + 0.001 * std::sin(40 * r.t_s[i]);
    }
    for (std::vector<double>* v : {&r.t_s, &r.q_rad, &r.torque_Nm}) v->resize(samples);
    r.torque_Nm.front() = 0;
    r.torque_Nm.back() = -1.2;
    EXPECT_TRUE(method::motion::torque_outliers(r).empty()) << samples;
  }
}

TEST(TorqueOutliers, ImpossibleSpikesAreFoundInShortRecordings) {
  joint::Recording r = loop(0.01);
  for (std::vector<double>* v : {&r.t_s, &r.q_rad, &r.torque_Nm}) v->resize(40);
  EXPECT_TRUE(method::motion::torque_outliers(r).empty());
  r.torque_Nm[39] += 40;
  EXPECT_EQ(method::motion::torque_outliers(r), std::vector<std::size_t>{39});
  for (const std::size_t i : {3UL, 11UL, 19UL, 27UL, 35UL}) r.torque_Nm[i] += 40;
  EXPECT_TRUE(method::motion::torque_outliers(r).empty()) << "more than one in ten are none";
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
