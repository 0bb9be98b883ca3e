#include "method/motion/traced_motion.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"
#include "wording/words.h"

namespace tribolog::traced_motion_test {
namespace {

/// A joint that swings with growing amplitude about 0.7 rad.
double growing(double t) { return 0.7 + 1e-4 * (1 + 0.3 * t) * std::sin(3 * t); }

joint::Recording recorded(double (*angle)(double), double duration_s, double rate_Hz,
                          double step = 0, double noise = 0) {
  joint::Recording r;
  statistics::RandomStream random(1, 0);
  const auto n = static_cast<int>(duration_s * rate_Hz) + 1;
  for (int i = 0; i < n; ++i) {
    const double q = angle(i / rate_Hz) + noise * random.normal();
    r.t_s.push_back(100 + i / rate_Hz);  // logs do not start at zero
    r.q_rad.push_back(step > 0 ? step * std::floor(q / step) : q);
    r.torque_Nm.push_back(0);
  }
  return r;
}

TEST(TracedMotion, CleanAngleComesBackWithItsSpeed) {
  const method::motion::MotionTrace trace =
      method::motion::trace_motion(recorded(growing, 10, 500));
  ASSERT_TRUE(trace.motion) << wording::words(trace.refusal);
  const auto motor = trace.motion->motor_motion(100);
  for (double t = 0.5; t < 9.5; t += 0.171) {
    EXPECT_NEAR(motor->angle(t), 100 * growing(t), 1e-9);
    const double speed = (growing(t + 1e-4) - growing(t - 1e-4)) / 2e-4;
    EXPECT_NEAR(motor->speed(t), 100 * speed, 1e-6);
  }
  EXPECT_EQ(trace.motion->strokes(), 11U);  // turns near cos(3 t) = 0, ten within 10 s
}

TEST(TracedMotion, EdgesOfTheStepsTellMoreThanTheSteps) {
  constexpr double step = 4e-6;  // a fiftieth of the first loop
  const method::motion::MotionTrace trace =
      method::motion::trace_motion(recorded(growing, 10, 500, step));
  ASSERT_TRUE(trace.motion) << wording::words(trace.refusal);
  EXPECT_NEAR(trace.motion->noise_rad, step / std::sqrt(12.0), 1e-3 * step);
  EXPECT_NEAR(trace.motion->residual_rad / trace.motion->noise_rad, 1, 0.05);
  EXPECT_NE(wording::words(trace.motion->noise_source()).find("encoder step"), std::string::npos);
  const auto joint = trace.motion->motor_motion(1);
  double squares = 0;
  double n = 0;
  for (double t = 0.5; t < 9.5; t += 0.0171) {
    squares += std::pow(joint->angle(t) - growing(t) + step / 2, 2);  // floor: half a step below
    n += 1;
  }
  EXPECT_LT(std::sqrt(squares / n), 0.25 * trace.motion->noise_rad);
}

/// Many steps from sample to sample: each sample's error is its own.
TEST(TracedMotion, AFastAngleIsNotFollowedIntoItsSteps) {
  constexpr double step = 1e-7;  // 30 of them between two samples at full speed
  const auto swinging = [](double t) { return 1e-4 * std::sin(2 * M_PI * 2.4 * t); };
  const method::motion::MotionTrace trace =
      method::motion::trace_motion(recorded(+swinging, 8, 500, step));
  ASSERT_TRUE(trace.motion) << wording::words(trace.refusal);
  EXPECT_NEAR(trace.motion->residual_rad / trace.motion->noise_rad, 0.9, 0.1);  // half: into them
  const auto joint = trace.motion->motor_motion(1);
  double squares = 0;
  double n = 0;
  for (double t = 0.5; t < 7.5; t += 0.0171) {
    const double acceleration = -std::pow(2 * M_PI * 2.4, 2) * swinging(t);
    squares += std::pow(joint->acceleration(t) - acceleration, 2);
    n += 1;
  }
  EXPECT_LT(std::sqrt(squares / n), 0.05 * 1e-4 * std::pow(2 * M_PI * 2.4, 2));
}

TEST(TracedMotion, WhiteNoiseIsFoundAndSmoothed) {
  const method::motion::MotionTrace trace =
      method::motion::trace_motion(recorded(growing, 10, 500, 0, 1e-6));
  ASSERT_TRUE(trace.motion) << wording::words(trace.refusal);
  EXPECT_NEAR(trace.motion->noise_rad / 1e-6, 1, 0.1);
  EXPECT_NEAR(trace.motion->residual_rad / 1e-6, 1, 0.1);
  EXPECT_NE(wording::words(trace.motion->noise_source()).find("scatter"), std::string::npos);
}

TEST(TracedMotion, RoughAngleIsRefusedWithItsNoise) {
  const method::motion::MotionTrace trace =
      method::motion::trace_motion(recorded(growing, 10, 500, 0, 2e-5));
  EXPECT_FALSE(trace.motion);
  EXPECT_NE(wording::words(trace.refusal).find("too noisy to give a speed"), std::string::npos)
      << wording::words(trace.refusal);
  EXPECT_NE(wording::words(trace.refusal).find("2×10⁻⁵ rad"), std::string::npos)
      << wording::words(trace.refusal);
}

TEST(TracedMotion, ShakingWithinAStrokeIsRefused) {
  const auto shaking = [](double t) { return growing(t) + 2e-6 * std::sin(600 * t); };
  const method::motion::MotionTrace trace =
      method::motion::trace_motion(recorded(+shaking, 10, 6000, 0, 5e-7));
  EXPECT_FALSE(trace.motion);
  EXPECT_NE(wording::words(trace.refusal).find("back and forth by"), std::string::npos)
      << wording::words(trace.refusal);
}

TEST(TracedMotion, RefusesWhatIsNoLoop) {
  const auto refusal = [](const joint::Recording& r) {
    return wording::words(method::motion::trace_motion(r).refusal);
  };
  EXPECT_NE(refusal(recorded(growing, 0.05, 500)).find("26 samples"), std::string::npos);
  EXPECT_NE(refusal(recorded([](double) { return 1.0; }, 10, 100)).find("does not change"),
            std::string::npos);
  EXPECT_NE(
      refusal(recorded([](double t) { return t; }, 10, 100)).find("1 stroke, with 0 reversals"),
      std::string::npos);
  EXPECT_NE(refusal(recorded(growing, 30, 10)).find("samples per stroke"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::traced_motion_test
