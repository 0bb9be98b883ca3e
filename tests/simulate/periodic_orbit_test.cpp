// The motion that repeats: known where the law is linear, the limit of any start where it is not.

#include "simulate/periodic_orbit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "friction/lugre.h"

namespace tribolog::periodic_orbit_test {
namespace {

using std::numbers::pi;

simulate::PeriodicOrbitSetup sinusoidal(double amplitude_N, double frequency_Hz,
                                        double mean_N = 0) {
  simulate::PeriodicOrbitSetup setup;
  setup.applied_Nm = [=](double t) {
    return mean_N + amplitude_N * std::sin(2 * pi * frequency_Hz * t);
  };
  setup.period_s = 1 / frequency_Hz;
  setup.samples = 400;
  return setup;
}

double width_of(const simulate::ForcedMotion& motion) {
  const auto [low, high] = std::minmax_element(motion.angle_rad.begin(), motion.angle_rad.end());
  return *high - *low;
}

/// More periods of the same, from the orbit's start or from rest.
simulate::ForcedMotion periods(const friction::DynamicFriction& friction,
                               const simulate::PeriodicOrbitSetup& setup, int count,
                               const simulate::PeriodicOrbit* from) {
  simulate::ForcedMotionSetup forced;
  forced.inertia_kgm2 = setup.inertia_kgm2;
  forced.applied_Nm = [&](double t, double, double) { return setup.applied_Nm(t); };
  forced.duration_s = count * setup.period_s;
  forced.sample_s = setup.period_s / static_cast<double>(setup.samples);
  if (from != nullptr) {
    forced.angle_rad = from->cycle.angle_rad.front();
    forced.speed_rad_s = from->cycle.speed_rad_s.front();
    forced.friction_state = from->start_state;
  }
  return simulate::simulate_forced_motion(friction, forced);
}

// m dv/dt + c v = F sin(w t) has v = Im(F exp(i w t)/(c + i w m)). A start dies away with
// exp(-c t/m), here by 1.6 % a period, so that waiting for the orbit would take a thousand periods.
TEST(PeriodicOrbit, OfALinearLawIsTheKnownOneHoweverLittleItIsDamped) {
  constexpr double mass = 2;
  constexpr double viscous = 0.02;
  constexpr double amplitude = 3;
  constexpr double omega = 4;
  const friction::LuGreFriction friction({1e-6, 0, viscous, 1e-12, 1e-12, 1.0});
  simulate::PeriodicOrbitSetup setup;
  setup.inertia_kgm2 = mass;
  setup.applied_Nm = [=](double t) { return amplitude * std::sin(omega * t); };
  setup.period_s = 2 * pi / omega;
  setup.samples = 100;
  const simulate::PeriodicOrbit orbit = simulate::periodic_orbit(friction, setup);
  EXPECT_TRUE(orbit.converged) << orbit.gap;
  EXPECT_LE(orbit.corrections, 5);
  const std::complex<double> gain = amplitude / std::complex<double>(viscous, omega * mass);
  double apart = 0;
  for (std::size_t i = 0; i < orbit.cycle.t_s.size(); ++i) {
    const double speed = (gain * std::polar(1.0, omega * orbit.cycle.t_s[i])).imag();
    apart = std::max(apart, std::abs(orbit.cycle.speed_rad_s[i] - speed));
  }
  // With so little damping a gap of 1e-8 is 60 times that in the distance from the orbit.
  EXPECT_LT(apart, 2e-6 * std::abs(gain));
}

class Orbits : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<friction::DynamicFriction> model_ =
      friction::dynamic_friction_model(GetParam()).matched({});
};

INSTANTIATE_TEST_SUITE_P(Models, Orbits,
                         testing::Values("dahl", "bliman_sorine", "lugre", "elasto_plastic"),
                         [](const auto& which) { return which.param; });

TEST_P(Orbits, RepeatPeriodAfterPeriod) {
  const simulate::PeriodicOrbitSetup setup = sinusoidal(1.3, 10);
  const simulate::PeriodicOrbit orbit = simulate::periodic_orbit(*model_, setup);
  EXPECT_TRUE(orbit.converged) << orbit.gap;
  const double width = width_of(orbit.cycle);
  const simulate::ForcedMotion three = periods(*model_, setup, 3, &orbit);
  for (std::size_t i = 0; i + setup.samples < three.t_s.size(); ++i) {
    EXPECT_NEAR(three.angle_rad[i + setup.samples], three.angle_rad[i], 1e-6 * width) << i;
    EXPECT_NEAR(three.friction_Nm[i + setup.samples], three.friction_Nm[i], 1e-5) << i;
  }
}

// The second half of the force mirrors its first half, and so does the motion.
TEST_P(Orbits, MirrorTheirFirstHalfUnderAForceThatDoes) {
  const simulate::PeriodicOrbitSetup setup = sinusoidal(1.3, 10);
  const simulate::PeriodicOrbit orbit = simulate::periodic_orbit(*model_, setup);
  const double width = width_of(orbit.cycle);
  EXPECT_LT(std::abs(orbit.drift_rad), 1e-7 * width);
  const std::size_t half = setup.samples / 2;
  for (std::size_t i = 0; i + half < orbit.cycle.t_s.size(); ++i) {
    EXPECT_NEAR(orbit.cycle.angle_rad[i + half], -orbit.cycle.angle_rad[i], 1e-6 * width) << i;
  }
}

TEST(PeriodicOrbit, IsWhereAMotionFromRestEnds) {
  const auto lugre = friction::dynamic_friction_model("lugre").matched({});
  const simulate::PeriodicOrbitSetup setup = sinusoidal(1.3, 10);
  const simulate::PeriodicOrbit orbit = simulate::periodic_orbit(*lugre, setup);
  constexpr int many = 8;
  const simulate::ForcedMotion from_rest = periods(*lugre, setup, many, nullptr);
  const std::size_t last = (many - 1) * setup.samples;
  for (std::size_t i = 0; i <= setup.samples; ++i) {
    EXPECT_NEAR(from_rest.friction_Nm[last + i], orbit.cycle.friction_Nm[i], 1e-6) << i;
  }
}

// A mean force below break-away makes LuGre creep: what repeats then is all but the angle.
TEST(PeriodicOrbit, GivesTheDriftOfAForceThatIsNotMirrored) {
  const auto lugre = friction::dynamic_friction_model("lugre").matched({});
  const simulate::PeriodicOrbitSetup setup = sinusoidal(0.6, 5, 0.4);
  const simulate::PeriodicOrbit orbit = simulate::periodic_orbit(*lugre, setup);
  EXPECT_TRUE(orbit.converged) << orbit.gap;
  EXPECT_GT(orbit.drift_rad, 1e-2 * width_of(orbit.cycle));
  const simulate::ForcedMotion three = periods(*lugre, setup, 3, &orbit);
  EXPECT_NEAR(three.angle_rad.back() - three.angle_rad.front(), 3 * orbit.drift_rad,
              1e-5 * orbit.drift_rad);
}

TEST(PeriodicOrbit, IsCentred) {
  const auto lugre = friction::dynamic_friction_model("lugre").matched({});
  const simulate::PeriodicOrbit orbit = simulate::periodic_orbit(*lugre, sinusoidal(1.0, 25, 0.1));
  const auto [low, high] =
      std::minmax_element(orbit.cycle.angle_rad.begin(), orbit.cycle.angle_rad.end());
  EXPECT_NEAR(*low, -*high, 1e-12 * *high);
}

TEST(PeriodicOrbit, SaysThatItDidNotConverge) {
  const auto lugre = friction::dynamic_friction_model("lugre").matched({});
  simulate::PeriodicOrbitSetup setup = sinusoidal(1.0, 25);
  setup.most_corrections = 0;
  const simulate::PeriodicOrbit orbit = simulate::periodic_orbit(*lugre, setup);
  EXPECT_FALSE(orbit.converged);
  EXPECT_GT(orbit.gap, setup.closed_to);
}

TEST(PeriodicOrbit, RefusesWhatCannotBe) {
  const auto lugre = friction::dynamic_friction_model("lugre").matched({});
  const auto refuses = [&](auto change) {
    simulate::PeriodicOrbitSetup setup = sinusoidal(1, 10);
    change(setup);
    EXPECT_THROW(simulate::periodic_orbit(*lugre, setup), std::invalid_argument);
  };
  refuses([](simulate::PeriodicOrbitSetup& s) { s.period_s = 0; });
  refuses([](simulate::PeriodicOrbitSetup& s) { s.samples = 0; });
  refuses([](simulate::PeriodicOrbitSetup& s) { s.inertia_kgm2 = -1; });
  refuses([](simulate::PeriodicOrbitSetup& s) { s.relative_tolerance = 0; });
  refuses([](simulate::PeriodicOrbitSetup& s) { s.closed_to = 0; });
  refuses([](simulate::PeriodicOrbitSetup& s) { s.applied_Nm = nullptr; });
}

}  // namespace
}  // namespace tribolog::periodic_orbit_test
