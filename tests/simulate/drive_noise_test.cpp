#include "simulate/drive_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "simulate/simulate_joint.h"
#include "support/paper_joint.h"

namespace tribolog::drive_noise_test {
namespace {

const joint::Recording& oscillation_of(const std::vector<joint::Recording>& recordings) {
  for (const joint::Recording& r : recordings) {
    if (r.role == joint::Role::oscillation) return r;
  }
  throw std::runtime_error("no oscillation");
}

TEST(DriveNoise, NoneLeavesEveryBit) {
  const auto clean = simulate::simulate_joint(test::paper_joint());
  joint::Recording r = oscillation_of(clean);
  simulate::add_drive_noise(r, simulate::Noise{}, 100, 1000, 0);
  EXPECT_EQ(r.torque_Nm, oscillation_of(clean).torque_Nm);
  EXPECT_EQ(r.q_rad, oscillation_of(clean).q_rad);
  EXPECT_EQ(r.dq_rad_s, oscillation_of(clean).dq_rad_s);
}

TEST(DriveNoise, IsWhatWasAskedFor) {
  const simulate::Scenario noisy = test::noisy_paper_joint(5);
  simulate::Scenario quiet = noisy;
  quiet.noise = simulate::Noise{};
  const auto with = simulate::simulate_joint(noisy);
  const auto without = simulate::simulate_joint(quiet);
  const joint::Recording& a = oscillation_of(with);
  const joint::Recording& b = oscillation_of(without);
  double squares = 0;
  const double encoder_step = 2 * std::numbers::pi / 131072 / 100;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = a.torque_Nm[i] - b.torque_Nm[i];
    squares += d * d;
    EXPECT_NEAR(std::remainder(a.torque_Nm[i], 0.005), 0, 1e-12);
    EXPECT_GE(b.q_rad[i] - a.q_rad[i], -1e-15);
    EXPECT_LT(b.q_rad[i] - a.q_rad[i], encoder_step * (1 + 1e-9));
  }
  // White noise and the rounding's variance, step^2/12; five standard errors.
  const double variance = 0.02 * 0.02 + 0.005 * 0.005 / 12;
  const auto n = static_cast<double>(a.size());
  EXPECT_NEAR(squares / n, variance, 5 * variance * std::sqrt(2 / n));
}

TEST(DriveNoise, RippleRepeatsWithTheMotorTurn) {
  simulate::Scenario s = test::paper_joint();
  s.noise.ripple = {{0.02, 1, 0.3}, {0.02, 6, 0}};
  const auto with = simulate::simulate_joint(s);
  const auto without = simulate::simulate_joint(test::paper_joint());
  const joint::Recording& a = with.front();
  for (std::size_t i = 0; i < a.size(); i += 97) {
    const double motor = 100 * a.q_rad[i];
    const double expected = 0.02 * std::sin(motor + 0.3) + 0.02 * std::sin(6 * motor);
    EXPECT_NEAR(a.torque_Nm[i] - without.front().torque_Nm[i], expected, 1e-12);
  }
}

TEST(DriveNoise, SameSeedSameNumbersOtherSeedOthers) {
  const auto a = simulate::simulate_joint(test::noisy_paper_joint(1));
  const auto b = simulate::simulate_joint(test::noisy_paper_joint(1));
  const auto c = simulate::simulate_joint(test::noisy_paper_joint(2));
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].torque_Nm, b[k].torque_Nm);
    EXPECT_NE(a[k].torque_Nm, c[k].torque_Nm);
  }
}

// Stamps scatter about their ticks by what was asked for, in order even where that is more than a
// tick; the torque's noise is that of an even clock.
TEST(DriveNoise, ScattersTheClock) {
  simulate::Scenario even = test::noisy_paper_joint(1);
  simulate::Scenario uneven = even;
  uneven.noise.clock_jitter_s = 1e-4;
  const auto with = simulate::simulate_joint(uneven);
  const auto without = simulate::simulate_joint(even);
  const joint::Recording& a = oscillation_of(with);
  const joint::Recording& b = oscillation_of(without);
  double squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(a.t_s[i] - b.t_s[i], 2);
  const auto n = static_cast<double>(a.size());
  EXPECT_NEAR(std::sqrt(squares / n), 1e-4, 5e-4 / std::sqrt(2 * n));
  EXPECT_EQ(a.torque_Nm, b.torque_Nm);
  EXPECT_EQ(a.q_rad, b.q_rad);

  uneven.noise.clock_jitter_s = 1;
  for (const joint::Recording& r : simulate::simulate_joint(uneven)) {
    EXPECT_TRUE(std::is_sorted(r.t_s.begin(), r.t_s.end())) << r.name;
  }
}

// What is left are samples of the whole log, and as many as a share by chance leaves.
TEST(DriveNoise, LosesSamples) {
  simulate::Scenario gaps = test::noisy_paper_joint(1);
  gaps.noise.lost_percent = 2;
  const auto with = simulate::simulate_joint(gaps);
  const auto without = simulate::simulate_joint(test::noisy_paper_joint(1));
  const joint::Recording& a = with.front();
  const joint::Recording& b = without.front();
  const double expected = 0.98 * static_cast<double>(b.size());
  EXPECT_NEAR(static_cast<double>(a.size()), expected, 5 * std::sqrt(0.02 * expected));
  EXPECT_EQ(a.rows_read, a.size());
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    while (j < b.size() && b.t_s[j] < a.t_s[i]) ++j;
    ASSERT_LT(j, b.size());
    ASSERT_EQ(a.t_s[i], b.t_s[j]);
    ASSERT_EQ(a.q_rad[i], b.q_rad[j]);
    ASSERT_EQ(a.dq_rad_s[i], b.dq_rad_s[j]);
    ASSERT_EQ(a.torque_Nm[i], b.torque_Nm[j]);
  }
}

}  // namespace
}  // namespace tribolog::drive_noise_test
