#include "simulate/force_experiments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "friction/catalogue.h"

namespace tribolog::test {
namespace {

using std::numbers::pi;

constexpr double mean_push_N = 0.4;
constexpr double swing_of_push_N = 0.2;

}  // namespace

simulate::ForcedMotionSetup push_below_break_away(double duration_s) {
  constexpr double frequency_Hz = 5;
  constexpr double rise_s = 0.2;
  simulate::ForcedMotionSetup setup;
  setup.applied_Nm = [](double t, double, double) {
    return std::min(1.0, t / rise_s) *
           (mean_push_N + swing_of_push_N * std::sin(2 * pi * frequency_Hz * t));
  };
  setup.duration_s = duration_s;
  setup.sample_s = 0.001;
  return setup;
}

double deflection_of_that_push_m() {
  return (mean_push_N + swing_of_push_N) / friction::ContactParameters{}.stiffness_Nm_rad;
}

double mean_displacement_m(const simulate::ForcedMotion& motion, double until_s) {
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < motion.t_s.size(); ++i) {
    if (motion.t_s[i] <= until_s - 1 || motion.t_s[i] > until_s) continue;
    sum += motion.angle_rad[i];
    ++count;
  }
  return sum / count;
}

simulate::ForcedMotionSetup sinusoidal_push(double amplitude_N, double frequency_Hz, double periods,
                                            double samples_per_period) {
  simulate::ForcedMotionSetup setup;
  setup.applied_Nm = [=](double t, double, double) {
    return amplitude_N * std::sin(2 * pi * frequency_Hz * t);
  };
  setup.duration_s = periods / frequency_Hz;
  setup.sample_s = 1 / (samples_per_period * frequency_Hz);
  return setup;
}

simulate::ForcedMotionSetup drawn_by_a_spring() {
  constexpr double spring_N_m = 2;
  simulate::ForcedMotionSetup setup;
  setup.applied_Nm = [](double t, double x, double) { return spring_N_m * (drawn_m_s * t - x); };
  setup.duration_s = 60;
  setup.sample_s = 0.01;
  return setup;
}

SpeedRange settled_speeds(const simulate::ForcedMotion& motion) {
  const auto& speed = motion.speed_rad_s;
  const auto begin = speed.begin() + static_cast<std::ptrdiff_t>(speed.size() / 2);
  const auto [slowest, fastest] = std::minmax_element(begin, speed.end());
  return {*slowest, *fastest};
}

simulate::ForcedMotionSetup rising_push(double rate_N_s, double sample_s) {
  constexpr double enough_N = 1.6;
  simulate::ForcedMotionSetup setup;
  setup.applied_Nm = [=](double t, double, double) { return rate_N_s * t; };
  setup.duration_s = enough_N / rate_N_s;
  setup.sample_s = sample_s;
  return setup;
}

double largest_friction_N(const simulate::ForcedMotion& motion) {
  return *std::max_element(motion.friction_Nm.begin(), motion.friction_Nm.end());
}

EnergyBalance energy_of(const simulate::ForcedMotion& m) {
  EnergyBalance energy{0, 0, m.speed_rad_s.back() * m.speed_rad_s.back() / 2};
  for (std::size_t i = 1; i < m.t_s.size(); ++i) {
    const double way = m.angle_rad[i] - m.angle_rad[i - 1];
    energy.put_in_J += (m.applied_Nm[i] + m.applied_Nm[i - 1]) / 2 * way;
    energy.taken_J += (m.friction_Nm[i] + m.friction_Nm[i - 1]) / 2 * way;
  }
  return energy;
}

}  // namespace tribolog::test
