// What a model leaves of an oscillation, held against what repeats from cycle to cycle.

#include "method/hysteresis/cycle_misfit.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::cycle_misfit_test {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double noise_Nm = 0.02;

/// Ten cycles of 1 Hz; what is left is an error by time, and noise that hangs together over some
/// samples.
method::hysteresis::CycleMisfit misfit_of(const std::function<double(double t_s)>& error,
                                          double colour, std::uint64_t seed) {
  statistics::RandomStream random(seed, 0);
  joint::Recording r;
  double state = 0;
  for (int i = 0; i <= 10000; ++i) {
    const double t = 1e-3 * i;
    state = colour * state + std::sqrt(1 - colour * colour) * noise_Nm * random.normal();
    r.t_s.push_back(t);
    r.q_rad.push_back(std::sin(2 * pi * t));
    r.torque_Nm.push_back(error(t) + state);
  }
  return method::hysteresis::cycle_misfit(r, std::vector<double>(r.size(), 0.0), 1.0);
}

double none(double) { return 0; }

TEST(CycleMisfit, RaisesFewFalseAlarmsWhateverTheColourOfTheNoise) {
  constexpr int runs = 400;
  for (const double colour : {0.0, 0.9}) {
    int alarms = 0;
    for (int k = 0; k < runs; ++k) {
      alarms += misfit_of(none, colour, static_cast<std::uint64_t>(k)).is_significant() ? 1 : 0;
    }
    EXPECT_LE(alarms, 12) << colour;  // one in a hundred is allowed; three would be 2.5 sigma more
  }
}

TEST(CycleMisfit, FindsAnErrorFarBelowTheNoise) {
  const auto found = misfit_of([](double t) { return 2e-3 * std::cos(6 * pi * t); }, 0, 1);
  EXPECT_EQ(found.cycles, 9U);
  EXPECT_TRUE(found.is_significant());
  EXPECT_NEAR(found.systematic_Nm, 2e-3 / std::sqrt(2), 0.5e-3);
  EXPECT_NEAR(found.harmonics[2].amplitude_Nm, 2e-3, 4 * found.harmonics[2].noise_Nm);
  EXPECT_GT(found.odd_share, 0.8);
}

TEST(CycleMisfit, TellsEvenFromOddHarmonics) {
  const auto found = misfit_of([](double t) { return 0.01 * std::cos(4 * pi * t); }, 0, 1);
  EXPECT_TRUE(found.is_significant());
  EXPECT_GT(found.even_share, 0.95);
}

TEST(CycleMisfit, IsNotHiddenByADriftFromCycleToCycle) {
  const auto found = misfit_of(
      [](double t) { return 4e-3 * std::cos(6 * pi * t) + 0.02 * (t - 5) * std::cos(6 * pi * t); },
      0, 1);
  EXPECT_TRUE(found.is_significant());
}

TEST(CycleMisfit, SaysNothingOfTooFewCycles) {
  joint::Recording r;
  for (int i = 0; i < 3000; ++i) {
    r.t_s.push_back(1e-3 * i);
    r.q_rad.push_back(0);
    r.torque_Nm.push_back(1);
  }
  const auto found = method::hysteresis::cycle_misfit(r, std::vector<double>(r.size(), 0.0), 1.0);
  EXPECT_FALSE(found.is_known());
  EXPECT_FALSE(found.is_significant());
}

}  // namespace
}  // namespace tribolog::cycle_misfit_test
