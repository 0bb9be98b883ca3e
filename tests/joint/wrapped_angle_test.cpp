// Angles that a log holds modulo a period go on; angles that jump for another reason are left
// alone.

#include "joint/wrapped_angle.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace tribolog::wrapped_angle_test {
namespace {

constexpr double turn = 2 * std::numbers::pi;
const std::vector<double> turns{turn};

struct Log {
  std::vector<double> t_s, q;
};

/// Sweeps to and fro over `travel`, with a change of direction in the middle of a period.
Log sweep(double travel, double rate_Hz = 50) {
  Log log;
  const auto samples = static_cast<std::size_t>(60 * rate_Hz);
  for (std::size_t i = 0; i < samples; ++i) {
    log.t_s.push_back(static_cast<double>(i) / rate_Hz);
    log.q.push_back(travel * std::sin(0.2 * log.t_s.back()) + 0.3);
  }
  return log;
}

std::vector<double> wrapped(const std::vector<double>& q, double period, double from) {
  std::vector<double> out;
  for (const double one : q) out.push_back(one - period * std::floor((one - from) / period));
  return out;
}

void expect_goes_on(const Log& log, const std::vector<double>& logged, double period) {
  const auto wraps = joint::find_wraps(log.t_s, logged, turns);
  ASSERT_TRUE(wraps);
  EXPECT_DOUBLE_EQ(wraps->period, period);
  const std::vector<double> q = joint::unwrapped(logged, *wraps);
  for (std::size_t i = 0; i < q.size(); ++i) {
    EXPECT_NEAR(q[i] - q[0], log.q[i] - log.q[0], 1e-9) << i;
  }
}

TEST(WrappedAngle, GoesOnByTurnsAndByTheFieldOfADrivesMessage) {
  const Log log = sweep(40);
  expect_goes_on(log, wrapped(log.q, turn, 0), turn);
  expect_goes_on(log, wrapped(log.q, turn, -turn / 2), turn);
  expect_goes_on(log, wrapped(log.q, 2 * turn, -turn), 2 * turn);
  expect_goes_on(log, wrapped(log.q, 25, -12.5), 25);
  expect_goes_on(log, wrapped(log.q, 8, -4), 8);
}

TEST(WrappedAngle, PassesOverGaps) {
  const Log log = sweep(40);
  std::vector<double> logged = wrapped(log.q, turn, 0);
  logged[500] = std::nan("");
  const auto wraps = joint::find_wraps(log.t_s, logged, turns);
  ASSERT_TRUE(wraps);
  EXPECT_NEAR(joint::unwrapped(logged, *wraps).back() - logged.front(),
              log.q.back() - log.q.front(), 1e-9);
}

TEST(WrappedAngle, OneThatDoesNotWrapStaysAsItIs) {
  const Log log = sweep(40);
  EXPECT_FALSE(joint::find_wraps(log.t_s, log.q, turns));
  EXPECT_FALSE(joint::find_wraps(log.t_s, std::vector<double>(log.q.size(), 1.0), turns));
}

TEST(WrappedAngle, AStepBetweenTwoRestsIsNone) {
  Log log;
  for (int i = 0; i < 400; ++i) {
    log.t_s.push_back(0.1 * i);
    log.q.push_back(i / 50 % 2 == 0 ? -0.5 : 0.5);
  }
  EXPECT_FALSE(joint::find_wraps(log.t_s, log.q, turns));
}

TEST(WrappedAngle, ARunThatStartsAgainAfterAPauseIsNone) {
  Log log;
  for (int i = 0; i < 400; ++i) {
    log.t_s.push_back(0.01 * i + (i < 200 ? 0.0 : 3.0));
    log.q.push_back(-0.995 + 0.01 * (i % 200));
  }
  EXPECT_FALSE(joint::find_wraps(log.t_s, log.q, turns));
}

TEST(WrappedAngle, ADamagedSampleIsNone) {
  Log log = sweep(1);
  log.q[700] = -7;
  EXPECT_FALSE(joint::find_wraps(log.t_s, log.q, turns));
}

TEST(WrappedAngle, ARangeOfNoCertainPeriodIsLeftAlone) {
  const Log log = sweep(40);
  EXPECT_FALSE(joint::find_wraps(log.t_s, wrapped(log.q, 5.37, 1.3), turns));
}

}  // namespace
}  // namespace tribolog::wrapped_angle_test
