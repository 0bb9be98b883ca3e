// The models that jump under an applied torque: bonds that snap at random places, a bristle that is
// reset, friction without pre-sliding. LuGre goes the same way, to be compared with CVODE.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "marched_motion.h"

#include "friction/catalogue.h"
#include "simulate/model_portrait.h"

namespace tribolog {
namespace {

using std::numbers::pi;

class Jumping : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] ForcedMotion march(const ForcedMotionSetup& setup, double step_s) const {
    return test::marched_motion(*model_, setup, step_s, entry_.traits.presliding);
  }
  const FrictionModelEntry& entry_ = dynamic_friction_model(GetParam());
  std::unique_ptr<DynamicFriction> model_ = entry_.matched({});
};

INSTANTIATE_TEST_SUITE_P(Motion, Jumping,
                         testing::Values("haessig_bristles", "reset_integrator", "hess_soom",
                                         "lugre"),
                         [](const auto& which) { return which.param; });

ForcedMotionSetup below_break_away() {
  constexpr double frequency_Hz = 5;
  ForcedMotionSetup setup;
  setup.applied_Nm = [](double t, double, double) {
    const double rise = std::min(1.0, t / 0.2);
    return rise * (0.4 + 0.2 * std::sin(2 * pi * frequency_Hz * t));
  };
  setup.duration_s = 4;
  setup.sample_s = 0.001;
  return setup;
}

double mean_before(const ForcedMotion& m, std::size_t end) {
  double sum = 0;
  for (std::size_t i = end - 1000; i < end; ++i) sum += m.angle_rad[i] / 1000;
  return sum;
}

TEST_P(Jumping, DriftsUnderAnOscillatingTorqueOnlyIfItSaysSo) {
  // Bonds have no damping: without a damper the body would ring on and snap more of them.
  ContactParameters damped;
  damped.viscous_Nms_rad = 200;
  const auto model = entry_.matched(damped);
  const ForcedMotion m =
      test::marched_motion(*model, below_break_away(), 2e-5, entry_.traits.presliding);
  const double creep = mean_before(m, 4000) - mean_before(m, 2000);
  const double deflection = 0.6 / ContactParameters{}.stiffness_Nm_rad;
  if (entry_.traits.drifts) {
    EXPECT_GT(creep, 0.01 * deflection);
  } else {
    EXPECT_LT(std::abs(creep), 1e-3 * deflection);
  }
}

TEST_P(Jumping, TakesTheEnergyThatIsPutIn) {
  ForcedMotionSetup setup;
  setup.applied_Nm = [](double t, double, double) { return 2 * std::sin(4 * pi * t); };
  setup.duration_s = 1;
  setup.sample_s = 1e-5;
  const ForcedMotion m = march(setup, setup.sample_s);
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

// Friction that is larger at the start than in sliding makes a body that is drawn by a soft spring
// stick and slip, whether it falls with speed or with the way.
TEST_P(Jumping, SticksAndSlipsIfItTakesMoreToStart) {
  constexpr double spring_N_m = 2;
  constexpr double drawn_m_s = 0.1;
  ForcedMotionSetup setup;
  setup.applied_Nm = [=](double t, double x, double) { return spring_N_m * (drawn_m_s * t - x); };
  setup.duration_s = 60;
  setup.sample_s = 0.01;
  const ForcedMotion m = march(setup, 1e-4);
  const auto begin = m.speed_rad_s.begin() + static_cast<std::ptrdiff_t>(m.speed_rad_s.size() / 2);
  const double slowest = *std::min_element(begin, m.speed_rad_s.end());
  const double fastest = *std::max_element(begin, m.speed_rad_s.end());
  if (entry_.traits.stribeck || entry_.traits.break_away) {
    EXPECT_LT(slowest, 0.01 * drawn_m_s);
    EXPECT_GT(fastest, 1.5 * drawn_m_s);
  } else {
    EXPECT_LT(fastest - slowest, 0.6 * drawn_m_s);
  }
}

double break_away_torque(const ForcedMotion& m) {
  return *std::max_element(m.friction_Nm.begin(), m.friction_Nm.end());
}

// Pushed slowly it is the peak that the same model shows under slow motion. Bonds that are spread
// evenly at first snap together later: their peak lies above the Coulomb torque.
TEST_P(Jumping, BreaksAwayAtThePeakOfSlowMotion) {
  const auto at_rate = [&](double rate_N_s) {
    ForcedMotionSetup setup;
    setup.applied_Nm = [=](double t, double, double) { return rate_N_s * t; };
    setup.duration_s = 1.6 / rate_N_s;
    setup.sample_s = 1e-5;
    return break_away_torque(march(setup, setup.sample_s));
  };
  const double slow = at_rate(2);
  const double fast = at_rate(50);
  const double slow_motion = portrait_of(entry_, {}).largest_Nm;
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
  const auto lugre = dynamic_friction_model("lugre").matched({});
  ForcedMotionSetup setup;
  setup.applied_Nm = [](double t, double, double) { return 1.3 * std::sin(20 * pi * t); };
  setup.duration_s = 0.2;
  setup.sample_s = 1e-3;
  const ForcedMotion solved = simulate_forced_motion(*lugre, setup);
  const ForcedMotion coarse = test::marched_motion(*lugre, setup, 2e-6, true);
  const ForcedMotion fine = test::marched_motion(*lugre, setup, 1e-6, true);
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
}  // namespace tribolog
