// What acts on loops beside their contact is found with the size that was laid, and taken off; the
// intervals hold the joint; of what is stated absent there is nothing.

#include "method/hysteresis/loop_effects.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "support/loop_fit.h"
#include "support/paper_joint.h"

namespace tribolog::loop_effects_test {
namespace {

using method::hysteresis::LuGreParameterName;
namespace effect = joint::effect;

constexpr double gear_ratio = 100;

/// Loops at four motor angles, and a larger one.
std::vector<joint::Recording> loops(std::uint64_t seed) {
  simulate::Scenario s = test::noisy_paper_joint(seed);
  s.oscillation->sample_rate_Hz = 500;
  s.oscillation->cycles = 5;
  s.oscillation->amplitude_rad = 1e-4;
  std::vector<simulate::OscillationExperiment> all =
      simulate::spread_over_motor_turn(*s.oscillation, 4, gear_ratio);
  all.push_back(all.front());
  all.back().amplitude_rad *= 20;
  s.oscillation = all.front();
  s.further_oscillations.assign(all.begin() + 1, all.end());
  return test::oscillations_of(s);
}

method::hysteresis::KnownOfLoops everything() { return {}; }

method::hysteresis::KnownOfLoops without(const joint::Effect& absent) {
  method::hysteresis::KnownOfLoops known;
  known.effects.sizes.state(absent, 0);
  known.effects.sizes.state(effect::friction_of_recording, 0);
  return known;
}

struct Laid {
  std::string name;
  const joint::Effect* effect;
  /// Torque laid on a sample. @param number of the loop. @param x along it, -1 to 1.
  std::function<double(std::size_t number, double friction_Nm, double x)> torque_Nm;
};

std::vector<Laid> laid() {
  return {{"motor_turn", &effect::motor_turn,
           [](std::size_t k, double friction, double) {
             return 0.04 * friction * (k % 2 == 0 ? 1 : -1);
           }},
          {"asymmetry", &effect::asymmetry,
           [](std::size_t, double friction, double) { return 0.06 * std::abs(friction); }},
          {"smooth_over_angle", &effect::smooth_over_angle,
           [](std::size_t k, double, double x) { return (k % 2 == 0 ? 0.03 : -0.03) * x; }}};
}

/// Friction is what a loop has beside its middle.
void lay(const Laid& what, std::vector<joint::Recording>& all) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    joint::Recording& r = all[k];
    const auto [low, high] = std::minmax_element(r.torque_Nm.begin(), r.torque_Nm.end());
    const double middle_Nm = (*low + *high) / 2;
    const auto [from, to] = std::minmax_element(r.q_rad.begin(), r.q_rad.end());
    const double middle_rad = (*from + *to) / 2;
    const double half_rad = (*to - *from) / 2;
    for (std::size_t i = 0; i < r.size(); ++i) {
      r.torque_Nm[i] +=
          what.torque_Nm(k, r.torque_Nm[i] - middle_Nm, (r.q_rad[i] - middle_rad) / half_rad);
    }
  }
}

double misfit(const method::hysteresis::LuGreFit& fit) { return fit.misfit_share().value_or(1); }

TEST(LoopEffects, WhatIsLaidIsTakenOffAndTheIntervalHoldsTheJoint) {
  const auto truth = test::true_parameters(test::paper_joint());
  for (const Laid& what : laid()) {
    std::vector<joint::Recording> all = loops(5);
    lay(what, all);
    const method::hysteresis::LuGreFit with = test::fitted_loops(all, everything()).fit;
    const method::hysteresis::LuGreFit without_it =
        test::fitted_loops(all, without(*what.effect)).fit;
    ASSERT_TRUE(with.converged && without_it.converged) << what.name;
    EXPECT_LT(misfit(with), 0.5 * misfit(without_it)) << what.name;
    for (const LuGreParameterName name :
         {LuGreParameterName::bristle_stiffness, LuGreParameterName::static_torque}) {
      const auto found = with.shown(name);
      ASSERT_TRUE(found) << what.name << to_string(name);
      EXPECT_LT(found->low, truth.at(name)) << what.name << to_string(name);
      EXPECT_GT(found->high, truth.at(name)) << what.name << to_string(name);
      EXPECT_LT(found->half_width(), 0.1 * found->value) << what.name << to_string(name);
    }
  }
}

TEST(LoopEffects, WhatIsStatedAbsentWidensNothing) {
  const std::vector<joint::Recording> all = loops(6);
  const method::hysteresis::LuGreFit alone = test::fitted_loops(all).fit;
  const method::hysteresis::LuGreFit typical = test::fitted_loops(all, everything()).fit;
  const auto width = [](const method::hysteresis::LuGreFit& fit) {
    return fit.shown(LuGreParameterName::bristle_stiffness)->half_width();
  };
  EXPECT_GT(width(typical), 2 * width(alone));
  for (const method::hysteresis::LuGreParameter& p : alone.parameters) {
    EXPECT_TRUE(p.shares.empty()) << to_string(p.name);
  }
  double most = 0;
  for (const method::hysteresis::LuGreParameter& p : typical.parameters) {
    if (p.name != LuGreParameterName::bristle_stiffness) continue;
    ASSERT_FALSE(p.shares.empty());
    most = p.shares.front().share;
    for (std::size_t k = 1; k < p.shares.size(); ++k) {
      EXPECT_GE(p.shares[k - 1].share, p.shares[k].share);
    }
  }
  EXPECT_GT(most, 0.3);
  EXPECT_LT(most, 1.01);
}

TEST(LoopEffects, ALagThatNobodyKnowsIsInTheDamping) {
  const std::vector<joint::Recording> all = loops(7);
  method::hysteresis::KnownOfLoops late = test::contact_alone();
  late.effects.timing.half_width_s = 3e-4;
  const auto sure = test::fitted_loops(all).fit;
  const auto unsure = test::fitted_loops(all, late).fit;
  const double stiffness = sure.shown(LuGreParameterName::bristle_stiffness)->value;
  const auto damping = unsure.shown(LuGreParameterName::bristle_damping);
  ASSERT_TRUE(damping);
  EXPECT_NEAR(
      damping->half_width(),
      std::hypot(sure.shown(LuGreParameterName::bristle_damping)->half_width(), stiffness * 3e-4),
      0.2 * stiffness * 3e-4);
  EXPECT_EQ(damping->value, sure.shown(LuGreParameterName::bristle_damping)->value);
}

/// The mean over seeds, of joints whose effects are drawn from what is typical.
TEST(LoopEffects, TypicalEffectsAreInsideAsOftenAsStated) {
  const auto truth = test::true_parameters(test::paper_joint());
  int inside = 0;
  int all_of_them = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    std::vector<joint::Recording> all = loops(seed);
    const double sign = seed % 2 == 0 ? 1 : -1;
    const double size = 0.2 * static_cast<double>(seed % 7) - 0.4;
    lay({"", nullptr,
         [&](std::size_t k, double friction, double x) {
           const double place = std::cos(1.3 * static_cast<double>(k % 4 + seed));
           return 0.01 * place * friction + 0.05 * size * std::abs(friction) + 1e-3 * sign * x;
         }},
        all);
    const auto fit = test::fitted_loops(all, everything()).fit;
    for (const LuGreParameterName name :
         {LuGreParameterName::bristle_stiffness, LuGreParameterName::static_torque}) {
      const auto found = fit.shown(name);
      ASSERT_TRUE(found);
      inside += found->low < truth.at(name) && truth.at(name) < found->high ? 1 : 0;
      ++all_of_them;
    }
  }
  EXPECT_GE(inside, all_of_them - 2);
}

}  // namespace
}  // namespace tribolog::loop_effects_test
