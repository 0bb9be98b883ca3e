// Models under an applied torque: what only the motion that follows can show.

#include "simulate/forced_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "friction/lugre.h"

namespace tribolog {
namespace {

using std::numbers::pi;

ForcedMotionSetup table_1(double amplitude_N, double frequency_Hz, double periods) {
  ForcedMotionSetup setup;
  setup.applied_Nm = [=](double t, double, double) {
    return amplitude_N * std::sin(2 * pi * frequency_Hz * t);
  };
  setup.duration_s = periods / frequency_Hz;
  setup.sample_s = 1 / (200 * frequency_Hz);
  return setup;
}

/// Models that hold at rest and are smooth enough for a solver: neither jumps nor hundreds of
/// bonds.
std::vector<std::string> solvable() {
  return {"dahl", "bliman_sorine", "armstrong", "lugre", "leuven", "elasto_plastic", "gms"};
}

class Forced : public testing::TestWithParam<std::string> {
 protected:
  const FrictionModelEntry& entry_ = dynamic_friction_model(GetParam());
  std::unique_ptr<DynamicFriction> model_ = entry_.matched({});
};

INSTANTIATE_TEST_SUITE_P(Motion, Forced, testing::ValuesIn(solvable()),
                         [](const auto& which) { return which.param; });

// A torque that stays below break-away all the time, and oscillates: does the rest position creep?
TEST_P(Forced, DriftsUnderAnOscillatingTorqueOnlyIfItSaysSo) {
  ForcedMotionSetup setup;
  constexpr double frequency = 5;
  setup.applied_Nm = [](double t, double, double) {
    const double rise = std::min(1.0, t / 0.2);
    return rise * (0.4 + 0.2 * std::sin(2 * pi * frequency * t));
  };
  setup.duration_s = 8;
  setup.sample_s = 0.001;
  const ForcedMotion m = simulate_forced_motion(*model_, setup);
  // A mean over a second: models without damping keep ringing.
  const auto mean_before = [&](std::size_t end) {
    double sum = 0;
    for (std::size_t i = end - 1000; i < end; ++i) sum += m.angle_rad[i] / 1000;
    return sum;
  };
  const double creep = mean_before(8000) - mean_before(4000);
  const double deflection = 0.6 / ContactParameters{}.stiffness_Nm_rad;
  if (entry_.traits.drifts) {
    EXPECT_GT(creep, 0.02 * deflection);
  } else {
    EXPECT_LT(std::abs(creep), 1e-3 * deflection);
  }
}

// Energy: what the torque puts in is what the mass has and friction took.
TEST_P(Forced, BalancesItsEnergy) {
  ForcedMotionSetup setup = table_1(2.0, 2.0, 2);
  setup.sample_s = 1e-5;
  const ForcedMotion m = simulate_forced_motion(*model_, setup);
  double put_in = 0;
  double taken = 0;
  for (std::size_t i = 1; i < m.t_s.size(); ++i) {
    const double way = m.angle_rad[i] - m.angle_rad[i - 1];
    put_in += (m.applied_Nm[i] + m.applied_Nm[i - 1]) / 2 * way;
    taken += (m.friction_Nm[i] + m.friction_Nm[i - 1]) / 2 * way;
  }
  const double kinetic = m.speed_rad_s.back() * m.speed_rad_s.back() / 2;
  EXPECT_GT(taken, 0);
  EXPECT_NEAR(put_in, taken + kinetic, 2e-3 * put_in);
}

// Drawn by a soft spring at constant speed in the falling part of the Stribeck curve.
TEST_P(Forced, SticksAndSlipsInALimitCycleIfFrictionFallsWithSpeed) {
  constexpr double spring_N_m = 2;
  constexpr double drawn_m_s = 0.1;
  ForcedMotionSetup setup;
  setup.applied_Nm = [=](double t, double x, double) { return spring_N_m * (drawn_m_s * t - x); };
  setup.duration_s = 60;
  setup.sample_s = 0.01;
  const ForcedMotion m = simulate_forced_motion(*model_, setup);
  const auto begin = m.speed_rad_s.begin() + static_cast<std::ptrdiff_t>(m.speed_rad_s.size() / 2);
  const double slowest = *std::min_element(begin, m.speed_rad_s.end());
  const double fastest = *std::max_element(begin, m.speed_rad_s.end());
  if (entry_.traits.stribeck) {
    EXPECT_LT(slowest, 0.01 * drawn_m_s);
    EXPECT_GT(fastest, 1.5 * drawn_m_s);
  } else {
    EXPECT_LT(fastest - slowest, 0.6 * drawn_m_s);
  }
}

/// The largest torque of friction on the way to sliding.
double break_away_torque(const DynamicFriction& model, double rate_N_s) {
  ForcedMotionSetup setup;
  setup.applied_Nm = [=](double t, double, double) { return rate_N_s * t; };
  setup.duration_s = 1.6 / rate_N_s;
  setup.sample_s = setup.duration_s / 16'000;
  const ForcedMotion m = simulate_forced_motion(model, setup);
  return *std::max_element(m.friction_Nm.begin(), m.friction_Nm.end());
}

// Canudas de Wit et al. 1995, fig. 4: the faster the force rises, the smaller the break-away force.
TEST_P(Forced, BreaksAwayEarlierTheFasterTheTorqueRisesIfStribeckIsInIt) {
  if (!entry_.traits.stribeck) return;
  const double slow = break_away_torque(*model_, 1);
  const double medium = break_away_torque(*model_, 10);
  const double fast = break_away_torque(*model_, 50);
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
  ForcedMotionSetup setup = table_1(1.3, 10, 2);
  const ForcedMotion whole = simulate_forced_motion(*model_, setup);
  setup.duration_s /= 2;
  const ForcedMotion first = simulate_forced_motion(*model_, setup);
  setup.angle_rad = first.angle_rad.back();
  setup.speed_rad_s = first.speed_rad_s.back();
  setup.friction_state = first.end_state;
  const ForcedMotion second = simulate_forced_motion(*model_, setup);
  const double width = *std::max_element(whole.angle_rad.begin(), whole.angle_rad.end()) -
                       *std::min_element(whole.angle_rad.begin(), whole.angle_rad.end());
  EXPECT_EQ(second.friction_Nm.front(), first.friction_Nm.back());
  EXPECT_NEAR(second.angle_rad.back(), whole.angle_rad.back(), restarted * width);
  EXPECT_NEAR(second.friction_Nm.back(), whole.friction_Nm.back(), restarted);
}

TEST(ForcedMotion, WithoutFrictionWorthMentioningFollowsNewton) {
  LuGreFriction::Parameters p{1e-6, 0, 0, 1e-12, 1e-12, 1.0};
  ForcedMotionSetup setup;
  setup.inertia_kgm2 = 2;
  setup.applied_Nm = [](double t, double, double) { return 3 * std::cos(4 * t); };
  setup.duration_s = 2;
  setup.sample_s = 0.1;
  const ForcedMotion m = simulate_forced_motion(LuGreFriction(p), setup);
  for (std::size_t i = 0; i < m.t_s.size(); ++i) {
    EXPECT_NEAR(m.speed_rad_s[i], 3.0 / 8 * std::sin(4 * m.t_s[i]), 1e-7);
    EXPECT_NEAR(m.angle_rad[i], 3.0 / 32 * (1 - std::cos(4 * m.t_s[i])), 1e-7);
  }
}

TEST(ForcedMotion, RefusesWhatCannotBe) {
  const auto lugre = dynamic_friction_model("lugre").matched({});
  ForcedMotionSetup setup = table_1(1, 1, 1);
  setup.inertia_kgm2 = 0;
  EXPECT_THROW(simulate_forced_motion(*lugre, setup), std::invalid_argument);
  setup = table_1(1, 1, 1);
  setup.applied_Nm = nullptr;
  EXPECT_THROW(simulate_forced_motion(*lugre, setup), std::invalid_argument);
  setup = table_1(1, 1, 1);
  setup.friction_state = {0.0, 0.0};
  EXPECT_THROW(simulate_forced_motion(*lugre, setup), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog
