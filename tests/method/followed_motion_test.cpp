// Which motion a model of the loop is driven along: harmonics where they describe the angle, also
// behind the start of a drive, and a spline where they do not.

#include "method/motion/followed_motion.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::followed_motion_test {
namespace {

constexpr double step = 1e-6;
constexpr double frequency_Hz = 1.5;

/// A servo's loop: no sine, since the contact bends over.
double swing(double t) {
  const double phase = 2 * M_PI * frequency_Hz * t;
  return 1e-3 * (std::sin(phase) + 0.06 * std::sin(3 * phase + 0.4) + 0.01 * std::cos(5 * phase));
}

/// What it takes a drive to catch up with a sine that begins with its full speed.
double catching_up(double t) { return -2e-4 * std::exp(-t / 0.03) * std::sin(60 * t); }

template <class Angle>
joint::Recording recorded(Angle angle, double duration_s = 6, double rate_Hz = 1000) {
  joint::Recording r;
  r.name = "loop.csv";
  for (int i = 0; i < static_cast<int>(duration_s * rate_Hz); ++i) {
    const double t = i / rate_Hz;
    r.t_s.push_back(50 + t);
    r.q_rad.push_back(step * std::round((0.4 + angle(t)) / step));
    r.torque_Nm.push_back(1 + std::sin(2 * M_PI * frequency_Hz * t));
  }
  return r;
}

/// Largest distance of a motion's speed from that of the swing, from one second on.
double speed_error(const simulate::Motion& motion) {
  double worst = 0;
  for (double t = 1; t < 5; t += 0.0037) {
    const double speed = (swing(t + 1e-4) - swing(t - 1e-4)) / 2e-4;
    worst = std::max(worst, std::abs(motion.speed(t) - speed));
  }
  return worst;
}

TEST(FollowedMotion, ASteadyLoopIsFollowedFromTheFirstSample) {
  const auto found = method::motion::follow_the_angle(recorded(swing), step);
  EXPECT_TRUE(found.is_followed);
  EXPECT_FALSE(found.traced);
  EXPECT_EQ(found.from_s, 0);
  ASSERT_TRUE(found.harmonic);
  EXPECT_LT(speed_error(found.harmonic->motor_motion(1)), 4e-5);
}

TEST(FollowedMotion, BehindADrivesStartTheHarmonicsAreThoseOfTheLaterCycles) {
  const auto found = method::motion::follow_the_angle(
      recorded([](double t) { return swing(t) + catching_up(t); }), step);
  EXPECT_TRUE(found.is_followed);
  EXPECT_FALSE(found.traced);
  EXPECT_NEAR(found.from_s, 1 / frequency_Hz, 0.01);
  ASSERT_TRUE(found.harmonic);
  EXPECT_LT(found.harmonic->residual_rad, step);
  EXPECT_EQ(found.harmonic->start_s, 50);  // they count time from the first sample as ever
  EXPECT_LT(speed_error(found.harmonic->motor_motion(1)), 4e-5);
}

TEST(FollowedMotion, ALoopThatChangesIsTraced) {
  const auto found = method::motion::follow_the_angle(
      recorded([](double t) { return (1 + 0.1 * t) * swing(t); }), step);
  EXPECT_TRUE(found.is_followed);
  EXPECT_TRUE(found.traced);
}

/// The fit of a spline's weight must not follow the noise everywhere for the sake of a blow.
TEST(FollowedMotion, ABlowAtTheStartDoesNotRoughenTheSpline) {
  const auto traced_error = [](double blow) {
    const auto found = method::motion::follow_the_angle(
        recorded([blow](double t) {
          return swing(t) + 2e-5 * t + blow * catching_up(t);  // it creeps: no harmonics
        }),
        step);
    EXPECT_TRUE(found.traced) << blow;
    return found.traced ? speed_error(*found.traced->motor_motion(1)) : NAN;
  };
  EXPECT_LT(traced_error(1), 1.2 * traced_error(0) + 1e-6);
}

}  // namespace
}  // namespace tribolog::followed_motion_test
