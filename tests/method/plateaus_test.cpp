#include "method/motion/plateaus.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simulate/motion.h"
#include "support/paper_joint.h"

namespace tribolog::plateaus_test {
namespace {

joint::Recording record(const simulate::Motion& motion, double duration_s, double rate_Hz,
                        double step_rad = 0) {
  joint::Recording r;
  for (double t = 0; t <= duration_s; t += 1 / rate_Hz) {
    const double q = motion.angle(t);
    r.t_s.push_back(t);
    r.q_rad.push_back(step_rad > 0 ? step_rad * std::floor(q / step_rad) : q);
    r.torque_Nm.push_back(0);
  }
  return r;
}

void expect_counts_add_up(const method::motion::MotionSegments& m, const joint::Recording& r) {
  EXPECT_EQ(m.samples_on_plateaus + m.samples_trimmed + m.samples_accelerating + m.samples_at_rest,
            r.size());
}

TEST(Plateaus, FindsBothStrokesOfATravelWithoutTheirRamps) {
  for (const double step : {0.0, 1e-5, 1e-4}) {
    for (const double speed : {0.02, 0.2, 2.0}) {
      const simulate::TravelMotion motion({-1, 0.8, speed, 20, true, 0.3});
      const joint::Recording r = record(motion, motion.duration_s(), 1000, step);
      const method::motion::MotionSegments m = method::motion::find_plateaus(r);
      ASSERT_EQ(m.plateaus.size(), 2U) << "speed " << speed << " step " << step;
      EXPECT_NEAR(m.plateaus[0].speed_rad_s, speed, 0.002 * speed);
      EXPECT_NEAR(m.plateaus[1].speed_rad_s, -speed, 0.002 * speed);
      for (const method::motion::Plateau& p : m.plateaus) {
        for (std::size_t i = p.first; i < p.last; ++i) {
          ASSERT_NEAR(std::abs(motion.speed(r.t_s[i])), speed, 1e-9) << "at " << r.t_s[i];
        }
      }
      EXPECT_GT(m.plateau_share(), 0.7);  // at 2 rad/s the ramps take a quarter of the motion
      expect_counts_add_up(m, r);
    }
  }
}

TEST(Plateaus, ASineIsNoConstantSpeed) {
  const joint::Recording r = record(simulate::HarmonicMotion::sine(0, 1.04, 0.1), 55, 100, 1e-4);
  const method::motion::MotionSegments m = method::motion::find_plateaus(r);
  EXPECT_LT(m.plateau_share(), 0.4);
  expect_counts_add_up(m, r);
}

TEST(Plateaus, AStandingJointHasNone) {
  joint::Recording r;
  for (int i = 0; i < 500; ++i) {
    r.t_s.push_back(i * 1e-3);
    r.q_rad.push_back(0.3);
    r.torque_Nm.push_back(1);
  }
  const method::motion::MotionSegments m = method::motion::find_plateaus(r);
  EXPECT_TRUE(m.plateaus.empty());
  EXPECT_EQ(m.samples_at_rest, 500U);
}

TEST(Plateaus, AStaircaseOfSpeedsHasOneForEach) {
  joint::Recording r;
  double q = 0;
  for (int i = 0; i < 40'000; ++i) {
    const double speed = 0.1 * (1 + i / 10'000);
    r.t_s.push_back(i * 1e-3);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(0);
    q += speed * 1e-3;
  }
  const method::motion::MotionSegments m = method::motion::find_plateaus(r);
  ASSERT_EQ(m.plateaus.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(m.plateaus[k].speed_rad_s, 0.1 * static_cast<double>(k + 1), 1e-4);
  }
  expect_counts_add_up(m, r);
}

TEST(Plateaus, FewSamplesAreNoMotion) {
  joint::Recording r;
  EXPECT_TRUE(method::motion::find_plateaus(r).plateaus.empty());
  r.t_s = {0, 1, 2};
  r.q_rad = {0, 1, 2};
  EXPECT_TRUE(method::motion::find_plateaus(r).plateaus.empty());
}

}  // namespace
}  // namespace tribolog::plateaus_test
