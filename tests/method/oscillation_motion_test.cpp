#include "method/motion/oscillation_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"
#include "support/paper_joint.h"

namespace tribolog::oscillation_motion_test {
namespace {

joint::Recording sampled(const simulate::Motion& motion, double duration_s, double rate_Hz) {
  joint::Recording r;
  const auto n = static_cast<int>(duration_s * rate_Hz) + 1;
  for (int i = 0; i < n; ++i) {
    r.t_s.push_back(100 + i / rate_Hz);  // logs do not start at zero
    r.q_rad.push_back(motion.angle(i / rate_Hz));
    r.torque_Nm.push_back(0);
  }
  return r;
}

TEST(OscillationMotion, FindsFrequencyAndHarmonics) {
  const simulate::HarmonicMotion truth(0.7, 1.37, {{0.002, 0.010}, {0.0005, 0}, {0, -0.0003}});
  const auto m = method::motion::fit_oscillation_motion(sampled(truth, 7.3, 500));
  ASSERT_TRUE(m);
  EXPECT_NEAR(m->frequency_Hz, 1.37, 1e-9);
  EXPECT_NEAR(m->centre_rad, 0.7, 1e-12);
  EXPECT_NEAR(m->amplitude_rad, std::hypot(0.002, 0.010), 1e-12);
  const simulate::HarmonicMotion motor = m->motor_motion(100);
  for (double t = 0; t < 7; t += 0.1) {
    EXPECT_NEAR(motor.angle(t), 100 * truth.angle(t), 1e-9);
    EXPECT_NEAR(motor.speed(t), 100 * truth.speed(t), 1e-7);
  }
}

/// A servo whose contact bends over: its motion has a third and higher harmonics.
TEST(OscillationMotion, TakesAsManyHarmonicsAsTheAngleShows) {
  std::vector<simulate::HarmonicMotion::Harmonic> harmonics(13);
  harmonics[0] = {0, 0.01};
  for (std::size_t k = 2; k < harmonics.size(); k += 2) {
    harmonics[k] = {2e-4 / static_cast<double>(k * k), 1e-4 / static_cast<double>(k)};
  }
  const simulate::HarmonicMotion truth(0.7, 1.37, harmonics);
  joint::Recording r = sampled(truth, 7.3, 500);
  const double step = 2 * 3.141592653589793 / 1e6;
  for (double& q : r.q_rad) q = step * std::round(q / step);
  const auto m = method::motion::fit_oscillation_motion(r);
  ASSERT_TRUE(m);
  EXPECT_GE(m->harmonics.size(), 13U);
  EXPECT_LT(m->residual_rad, 1.2 * step / std::sqrt(12.0));
  EXPECT_GT(m->near_sine_rad, 5 * m->residual_rad);
}

/// A stiff servo gives way to the torque of the contact by less than a step of the encoder; each
/// order by itself is below what the steps leave, all together are seen.
TEST(OscillationMotion, GivesWayToTheTorqueAsAServoDoes) {
  constexpr double amplitude = 0.01;
  constexpr double step = amplitude / 150;
  // Friction that bends over: like the sign of the speed, rounded.
  std::vector<simulate::HarmonicMotion::Harmonic> torque(31);
  for (std::size_t k = 1; k <= torque.size(); k += 2) {
    const auto order = static_cast<double>(k);
    torque[k - 1] = {1.3 / order / (1 + 0.02 * order * order), 0.2 / order / order};
  }
  constexpr double compliance = 0.2 * step;  // by N·m
  constexpr double late = 0.01 * step;       // by order
  std::vector<simulate::HarmonicMotion::Harmonic> motion(31);
  motion[0] = {0, amplitude};
  for (std::size_t k = 3; k <= motion.size(); k += 2) {
    const simulate::HarmonicMotion::Harmonic& t = torque[k - 1];
    const auto order = static_cast<double>(k);
    motion[k - 1] = {-compliance * t.cosine - late * order * t.sine,
                     -compliance * t.sine + late * order * t.cosine};
  }
  const simulate::HarmonicMotion truth(0.7, 1.0, motion);
  joint::Recording r = sampled(truth, 11, 1000);
  const simulate::HarmonicMotion friction(0, 1.0, torque);
  statistics::RandomStream noise(3, 0);
  for (std::size_t i = 0; i < r.size(); ++i) {
    r.q_rad[i] = step * std::round(r.q_rad[i] / step);
    r.torque_Nm[i] = friction.angle(r.t_s[i] - 100) + 0.03 * noise.normal();
  }
  const auto found = method::motion::fit_oscillation_motion(r);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->harmonics.size(), 31U);
  EXPECT_EQ(found->one_by_one, 3U);
  for (const std::size_t k : {5U, 7U, 9U, 15U}) {
    EXPECT_NEAR(found->harmonics[k - 1].cosine, motion[k - 1].cosine, 0.02 * step) << k;
    EXPECT_NEAR(found->harmonics[k - 1].sine, motion[k - 1].sine, 0.02 * step) << k;
  }
  // Fitted again to the same angles it is the same motion.
  const method::motion::OscillationMotion again =
      method::motion::HarmonicRefit(r.t_s, *found)(r.q_rad);
  EXPECT_NEAR(again.harmonics[4].cosine, found->harmonics[4].cosine, 0.01 * step);
  EXPECT_NEAR(again.harmonics[0].sine, found->harmonics[0].sine, 0.01 * step);
}

TEST(OscillationMotion, TakesNoneOfNoiseOrOfAnEncodersSteps) {
  const simulate::HarmonicMotion truth(0.7, 1.37, {{0.002, 0.010}, {0.0005, 0}, {0, -0.0003}});
  for (const double counts : {1e4, 1e5, 1e6}) {
    joint::Recording r = sampled(truth, 7.3, 500);
    const double step = 2 * 3.141592653589793 / counts;
    for (double& q : r.q_rad) q = step * std::round(q / step);
    EXPECT_LE(method::motion::fit_oscillation_motion(r)->harmonics.size(), 5U) << counts;
  }
}

TEST(OscillationMotion, OfALongRecordingTheLastRoundsSeeEverySample) {
  const simulate::HarmonicMotion truth(0.7, 1.37, {{0.002, 0.010}, {0.0005, 0}, {0, -0.0003}});
  joint::Recording r = sampled(truth, 120, 2000);
  const auto clean = method::motion::fit_oscillation_motion(r);
  ASSERT_TRUE(clean);
  EXPECT_NEAR(clean->frequency_Hz, 1.37, 1e-11);
  EXPECT_NEAR(clean->centre_rad, 0.7, 1e-12);
  EXPECT_NEAR(clean->amplitude_rad, std::hypot(0.002, 0.010), 1e-12);
  // Between the samples that the first rounds see.
  for (std::size_t i = 1; i < r.size(); i += 4) r.q_rad[i] += 1e-4;
  EXPECT_NEAR(method::motion::fit_oscillation_motion(r)->centre_rad, 0.7 + 0.25e-4, 1e-9);
}

TEST(OscillationMotion, OneCycleIsEnoughHalfIsNot) {
  const auto truth = simulate::HarmonicMotion::sine(0, 1e-4, 1);
  EXPECT_TRUE(method::motion::fit_oscillation_motion(sampled(truth, 1.0, 1000)));
  EXPECT_FALSE(method::motion::fit_oscillation_motion(sampled(truth, 0.45, 1000)));
}

TEST(OscillationMotion, ADriftingLoopIsNotFollowed) {
  const auto sine = simulate::HarmonicMotion::sine(0, 1e-4, 1);
  joint::Recording steady = sampled(sine, 5.0, 200);
  EXPECT_TRUE(method::motion::fit_oscillation_motion(steady)->is_near_sine(0));
  for (std::size_t i = 0; i < steady.size(); ++i) {
    steady.q_rad[i] += 1e-4 * std::exp(-static_cast<double>(i) / 200);
  }
  const auto motion = method::motion::fit_oscillation_motion(steady);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->is_near_sine(5e-6));
  EXPECT_TRUE(motion->is_near_sine(1e-4)) << "within a step of the encoder nothing is known";
}

TEST(OscillationMotion, AStandingJointDoesNotSwing) {
  joint::Recording r;
  for (int i = 0; i < 100; ++i) {
    r.t_s.push_back(i);
    r.q_rad.push_back(1);
    r.torque_Nm.push_back(0);
  }
  EXPECT_FALSE(method::motion::fit_oscillation_motion(r));
}

}  // namespace
}  // namespace tribolog::oscillation_motion_test
