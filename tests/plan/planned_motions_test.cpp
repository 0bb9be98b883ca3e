// Motions of a plan: from rest to rest, without jumps.

#include "plan/planned_motions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tribolog::planned_motions_test {
namespace {

using std::numbers::pi;

constexpr double amplitude = 1e-4;
constexpr double frequency = 2;
constexpr double ease = 0.04;

plan::EasedSine sine() { return {0.3, amplitude, frequency, 5, ease}; }

TEST(EasedSine, SpeedAndAccelerationAreTheDerivatives) {
  const plan::EasedSine m = sine();
  constexpr double h = 1e-6;
  const double speed_scale = 2 * pi * frequency * amplitude;
  for (double t = 2 * h; t < m.duration_s() - 2 * h; t += 0.00731) {
    EXPECT_NEAR(m.speed(t), (m.angle(t + h) - m.angle(t - h)) / (2 * h), 1e-6 * speed_scale) << t;
    EXPECT_NEAR(m.acceleration(t), (m.speed(t + h) - m.speed(t - h)) / (2 * h),
                1e-4 * speed_scale * 2 * pi * frequency + 1e-6)
        << t;
  }
}

TEST(EasedSine, StartsAndEndsAtRest) {
  const plan::EasedSine m = sine();
  for (const double t : {-1.0, 0.0, m.duration_s(), m.duration_s() + 1}) EXPECT_EQ(m.speed(t), 0);
  EXPECT_DOUBLE_EQ(m.angle(0), m.start_rad());
  EXPECT_DOUBLE_EQ(m.angle(m.duration_s()), m.end_rad());
  // Near its ends the speed grows as the square of time: the acceleration starts from nothing.
  EXPECT_LT(m.speed(1e-3 * ease), 1e-5 * 2 * pi * frequency * amplitude);
}

TEST(EasedSine, IsTheSineBetweenItsTransitions) {
  const plan::EasedSine m = sine();
  for (double t = ease; t < m.duration_s() - ease; t += 0.0123) {
    const double x = 2 * pi * frequency * (t - ease);
    EXPECT_NEAR(m.angle(t), 0.3 + amplitude * std::sin(x), 1e-15);
  }
  EXPECT_DOUBLE_EQ(m.duration_s(), 5 / frequency + 2 * ease);
}

// Read backwards about its centre it is the same motion.
TEST(EasedSine, IsOddAboutItsMiddle) {
  const plan::EasedSine m = sine();
  for (double t = 0; t < m.duration_s(); t += 0.0171) {
    EXPECT_NEAR(m.angle(t) - 0.3, 0.3 - m.angle(m.duration_s() - t), 1e-15) << t;
  }
}

TEST(EasedSine, KeepsTheStatedAcceleration) {
  for (const double e : {0.001, 0.02, 0.1}) {
    const plan::EasedSine m(0, amplitude, frequency, 2, e);
    const double bound = plan::EasedSine::largest_acceleration_rad_s2(amplitude, frequency, e);
    double largest = 0;
    for (double t = 0; t < m.duration_s(); t += 1e-4) {
      largest = std::max(largest, std::abs(m.acceleration(t)));
    }
    EXPECT_LE(largest, bound);
    EXPECT_GT(largest, 0.4 * bound);
  }
}

TEST(EasedSine, RefusesWhatItCannotBe) {
  EXPECT_THROW(plan::EasedSine(0, 0, 1, 1, 0.01), std::invalid_argument);
  EXPECT_THROW(plan::EasedSine(0, 1, 1, 0, 0.01), std::invalid_argument);
  EXPECT_THROW(plan::EasedSine(0, 1, 1, 1, 0.3), std::invalid_argument);
}

TEST(PlannedTravel, GoesSlowerWhereTheWayIsShort) {
  const auto m = plan::travel(0.1, 0.1001, 2, 1, false, 0.1);
  double fastest = 0;
  double hardest = 0;
  for (double t = 0; t < m->duration_s(); t += 1e-5) {
    fastest = std::max(fastest, m->speed(t));
    hardest = std::max(hardest, std::abs(m->acceleration(t)));
  }
  EXPECT_LT(fastest, 0.02);
  EXPECT_NEAR(hardest, 1, 1e-3);
  EXPECT_NEAR(m->angle(m->duration_s()), 0.1001, 1e-15);
}

}  // namespace
}  // namespace tribolog::planned_motions_test
