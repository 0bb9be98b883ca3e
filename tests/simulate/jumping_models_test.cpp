// The models that jump under an applied torque: bonds that snap at random places, a bristle that is
// reset, friction without pre-sliding. LuGre goes the same way, to be compared with CVODE.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "simulate/force_experiments.h"
#include "simulate/marched_motion.h"
#include "simulate/model_portrait.h"

namespace tribolog::jumping_models_test {
namespace {

class Jumping : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] simulate::ForcedMotion march(const simulate::ForcedMotionSetup& setup,
                                             double step_s) const {
    return test::marched_motion(*model_, setup, step_s, entry_.traits.presliding);
  }
  const friction::FrictionModelEntry& entry_ = friction::dynamic_friction_model(GetParam());
  std::unique_ptr<friction::DynamicFriction> model_ = entry_.matched({});
};

INSTANTIATE_TEST_SUITE_P(Motion, Jumping,
                         testing::Values("haessig_bristles", "reset_integrator", "hess_soom",
                                         "lugre"),
                         [](const auto& which) { return which.param; });

TEST_P(Jumping, DriftsUnderAnOscillatingTorqueOnlyIfItSaysSo) {
  // Bonds have no damping: without a damper the body would ring on and snap more of them.
  friction::ContactParameters damped;
  damped.viscous_Nms_rad = 200;
  const auto model = entry_.matched(damped);
  const simulate::ForcedMotion m =
      test::marched_motion(*model, test::push_below_break_away(4), 2e-5, entry_.traits.presliding);
  const double creep = test::mean_displacement_m(m, 4) - test::mean_displacement_m(m, 2);
  const double deflection = test::deflection_of_that_push_m();
  if (entry_.traits.drifts) {
    EXPECT_GT(creep, 0.01 * deflection);
  } else {
    EXPECT_LT(std::abs(creep), 1e-3 * deflection);
  }
}

TEST_P(Jumping, TakesTheEnergyThatIsPutIn) {
  const simulate::ForcedMotionSetup setup = test::sinusoidal_push(2, 2, 2, 50'000);
  const test::EnergyBalance energy = test::energy_of(march(setup, setup.sample_s));
  EXPECT_GT(energy.taken_J, 0);
  EXPECT_NEAR(energy.put_in_J, energy.taken_J + energy.kinetic_J, 2e-3 * energy.put_in_J);
}

// Friction that is larger at the start than in sliding makes a body that is drawn by a soft spring
// stick and slip, whether it falls with speed or with the way.
TEST_P(Jumping, SticksAndSlipsIfItTakesMoreToStart) {
  const test::SpeedRange speeds = test::settled_speeds(march(test::drawn_by_a_spring(), 1e-4));
  if (entry_.traits.stribeck || entry_.traits.break_away) {
    EXPECT_LT(speeds.slowest_m_s, 0.01 * test::drawn_m_s);
    EXPECT_GT(speeds.fastest_m_s, 1.5 * test::drawn_m_s);
  } else {
    EXPECT_LT(speeds.fastest_m_s - speeds.slowest_m_s, 0.6 * test::drawn_m_s);
  }
}

// Pushed slowly it is the peak that the same model shows under slow motion. Bonds that are spread
// evenly at first snap together later: their peak lies above the Coulomb torque.
TEST_P(Jumping, BreaksAwayAtThePeakOfSlowMotion) {
  const auto at_rate = [&](double rate_N_s) {
    constexpr double step_s = 1e-5;
    return test::largest_friction_N(march(test::rising_push(rate_N_s, step_s), step_s));
  };
  const double slow = at_rate(2);
  const double fast = at_rate(50);
  const double slow_motion = simulate::portrait_of(entry_, {}).largest_Nm;
  EXPECT_NEAR(slow, slow_motion, 0.08 * slow_motion);
  if (entry_.name == "lugre") {
    EXPECT_LT(fast, slow - 0.2);
  } else {  // damping before it breaks may add to it, nothing takes from it
    EXPECT_GT(fast, 0.95 * slow);
    EXPECT_LT(fast, 1.1 * slow);
  }
}

// The march and CVODE share no code but the model's law.
TEST(MarchedMotion, AgreesWithCvodeWhereTheModelIsSmooth) {
  const auto lugre = friction::dynamic_friction_model("lugre").matched({});
  const simulate::ForcedMotionSetup setup = test::sinusoidal_push(1.3, 10, 2, 100);
  const simulate::ForcedMotion solved = simulate::simulate_forced_motion(*lugre, setup);
  const simulate::ForcedMotion coarse = test::marched_motion(*lugre, setup, 2e-6, true);
  const simulate::ForcedMotion fine = test::marched_motion(*lugre, setup, 1e-6, true);
  const auto [low, high] = std::minmax_element(solved.angle_rad.begin(), solved.angle_rad.end());
  double coarse_apart = 0;
  double fine_apart = 0;
  for (std::size_t i = 0; i < solved.t_s.size(); ++i) {
    coarse_apart = std::max(coarse_apart, std::abs(coarse.angle_rad[i] - solved.angle_rad[i]));
    fine_apart = std::max(fine_apart, std::abs(fine.angle_rad[i] - solved.angle_rad[i]));
  }
  EXPECT_LT(fine_apart, 1e-3 * (*high - *low));
  EXPECT_LT(fine_apart, 0.6 * coarse_apart);
}

}  // namespace
}  // namespace tribolog::jumping_models_test
