// Models under an applied torque: what only the motion that follows can show.

#include "simulate/forced_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "friction/lugre.h"
#include "simulate/force_experiments.h"

namespace tribolog::forced_motion_test {
namespace {

using std::numbers::pi;

/// Models that hold at rest and are smooth enough for a solver: neither jumps nor hundreds of
/// bonds.
std::vector<std::string> solvable() {
  return {"dahl", "bliman_sorine", "armstrong", "lugre", "leuven", "elasto_plastic", "gms"};
}

class Forced : public testing::TestWithParam<std::string> {
 protected:
  const friction::FrictionModelEntry& entry_ = friction::dynamic_friction_model(GetParam());
  std::unique_ptr<friction::DynamicFriction> model_ = entry_.matched({});
};

INSTANTIATE_TEST_SUITE_P(Motion, Forced, testing::ValuesIn(solvable()),
                         [](const auto& which) { return which.param; });

// A torque that stays below break-away all the time, and oscillates: does the rest position creep?
TEST_P(Forced, DriftsUnderAnOscillatingTorqueOnlyIfItSaysSo) {
  const simulate::ForcedMotion m =
      simulate::simulate_forced_motion(*model_, test::push_below_break_away(8));
  const double creep = test::mean_displacement_m(m, 8) - test::mean_displacement_m(m, 4);
  const double deflection = test::deflection_of_that_push_m();
  if (entry_.traits.drifts) {
    EXPECT_GT(creep, 0.02 * deflection);
  } else {
    EXPECT_LT(std::abs(creep), 1e-3 * deflection);
  }
}

// Energy: what the torque puts in is what the mass has and friction took.
TEST_P(Forced, BalancesItsEnergy) {
  const test::EnergyBalance energy = test::energy_of(
      simulate::simulate_forced_motion(*model_, test::sinusoidal_push(2, 2, 2, 50'000)));
  EXPECT_GT(energy.taken_J, 0);
  EXPECT_NEAR(energy.put_in_J, energy.taken_J + energy.kinetic_J, 2e-3 * energy.put_in_J);
}

// Drawn by a soft spring at constant speed in the falling part of the Stribeck curve.
TEST_P(Forced, SticksAndSlipsInALimitCycleIfFrictionFallsWithSpeed) {
  const test::SpeedRange speeds =
      test::settled_speeds(simulate::simulate_forced_motion(*model_, test::drawn_by_a_spring()));
  if (entry_.traits.stribeck) {
    EXPECT_LT(speeds.slowest_m_s, 0.01 * test::drawn_m_s);
    EXPECT_GT(speeds.fastest_m_s, 1.5 * test::drawn_m_s);
  } else {
    EXPECT_LT(speeds.fastest_m_s - speeds.slowest_m_s, 0.6 * test::drawn_m_s);
  }
}

// Canudas de Wit et al. 1995, fig. 4: the faster the force rises, the smaller the break-away force.
TEST_P(Forced, BreaksAwayEarlierTheFasterTheTorqueRisesIfStribeckIsInIt) {
  if (!entry_.traits.stribeck) return;
  const auto at_rate = [&](double rate_N_s) {
    return test::largest_friction_N(
        simulate::simulate_forced_motion(*model_, test::rising_push(rate_N_s, 1e-4 / rate_N_s)));
  };
  const double slow = at_rate(1);
  const double medium = at_rate(10);
  const double fast = at_rate(50);
  EXPECT_LE(slow, 1.6);
  EXPECT_GT(fast, 1.0);
  if (entry_.name == "lugre" || entry_.name == "elasto_plastic") {
    EXPECT_GT(slow, medium);
    EXPECT_GT(medium, fast);
  }
}

// Nothing of the motion is hidden: its state at a moment is all that what follows depends on.
TEST_P(Forced, GoesOnFromTheStateInWhichItStopped) {
  constexpr double restarted = 1e-4;  // the solver forgets its step, and then chooses others
  simulate::ForcedMotionSetup setup = test::sinusoidal_push(1.3, 10, 2, 200);
  const simulate::ForcedMotion whole = simulate::simulate_forced_motion(*model_, setup);
  setup.duration_s /= 2;
  const simulate::ForcedMotion first = simulate::simulate_forced_motion(*model_, setup);
  setup.angle_rad = first.angle_rad.back();
  setup.speed_rad_s = first.speed_rad_s.back();
  setup.friction_state = first.end_state;
  const simulate::ForcedMotion second = simulate::simulate_forced_motion(*model_, setup);
  const double width = *std::max_element(whole.angle_rad.begin(), whole.angle_rad.end()) -
                       *std::min_element(whole.angle_rad.begin(), whole.angle_rad.end());
  EXPECT_EQ(second.friction_Nm.front(), first.friction_Nm.back());
  EXPECT_NEAR(second.angle_rad.back(), whole.angle_rad.back(), restarted * width);
  EXPECT_NEAR(second.friction_Nm.back(), whole.friction_Nm.back(), restarted);
}

TEST(ForcedMotion, WithoutFrictionWorthMentioningFollowsNewton) {
  friction::LuGreFriction::Parameters p{1e-6, 0, 0, 1e-12, 1e-12, 1.0};
  simulate::ForcedMotionSetup setup;
  setup.inertia_kgm2 = 2;
  setup.applied_Nm = [](double t, double, double) { return 3 * std::cos(4 * t); };
  setup.duration_s = 2;
  setup.sample_s = 0.1;
  const simulate::ForcedMotion m =
      simulate::simulate_forced_motion(friction::LuGreFriction(p), setup);
  for (std::size_t i = 0; i < m.t_s.size(); ++i) {
    EXPECT_NEAR(m.speed_rad_s[i], 3.0 / 8 * std::sin(4 * m.t_s[i]), 1e-7);
    EXPECT_NEAR(m.angle_rad[i], 3.0 / 32 * (1 - std::cos(4 * m.t_s[i])), 1e-7);
  }
}

TEST(ForcedMotion, RefusesWhatCannotBe) {
  const auto lugre = friction::dynamic_friction_model("lugre").matched({});
  simulate::ForcedMotionSetup setup = test::sinusoidal_push(1, 1, 1, 200);
  setup.inertia_kgm2 = 0;
  EXPECT_THROW(simulate::simulate_forced_motion(*lugre, setup), std::invalid_argument);
  setup = test::sinusoidal_push(1, 1, 1, 200);
  setup.applied_Nm = nullptr;
  EXPECT_THROW(simulate::simulate_forced_motion(*lugre, setup), std::invalid_argument);
  setup = test::sinusoidal_push(1, 1, 1, 200);
  setup.friction_state = {0.0, 0.0};
  EXPECT_THROW(simulate::simulate_forced_motion(*lugre, setup), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::forced_motion_test
