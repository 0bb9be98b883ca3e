// Every model's own method under prescribed motion against CVODE on the model's rates.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "friction/catalogue.h"
#include "simulate/model_portrait.h"
#include "support/cvode_friction.h"

namespace tribolog::friction_response_test {
namespace {

constexpr double dt_s = 1e-3;
constexpr std::size_t samples = 501;
const friction::ContactParameters contact;

/// Two strokes a second. Reversals do not fall on samples.
simulate::HarmonicMotion oscillation(double amplitude_rad) {
  return {0, 2, {{0.12 * amplitude_rad, amplitude_rad}, {0, 0}, {0, amplitude_rad / 3}}};
}

class AgainstCvode : public testing::TestWithParam<std::size_t> {
 protected:
  [[nodiscard]] std::vector<double> by_cvode(const simulate::Motion& motion) const {
    test::CvodeFrictionOptions options;
    options.method = simulate::CvodeSolver::Method::adams;
    options.relative_tolerance = 1e-10;
    options.largest_step_s = 0.01;
    options.first_step_s = 1e-6;
    options.reversals_s = test::reversals_of(motion, dt_s * samples, 0.003);
    std::vector<double> torque(samples);
    test::friction_by_cvode(*model_, motion, dt_s, options, torque);
    return torque;
  }
  [[nodiscard]] std::vector<double> by_our_method(const simulate::Motion& motion) const {
    std::vector<double> torque(samples);
    std::vector<double> state = model_->unloaded();
    simulate::friction_response(*model_, motion, 0, dt_s, state, torque);
    return torque;
  }
  [[nodiscard]] double apart(const simulate::Motion& motion) const {
    const std::vector<double> a = by_our_method(motion);
    const std::vector<double> b = by_cvode(motion);
    double worst = 0;
    for (std::size_t i = 0; i < samples; ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst / contact.static_Nm;
  }

  const friction::FrictionModelEntry& entry_ = friction::dynamic_friction_models()[GetParam()];
  std::unique_ptr<friction::DynamicFriction> model_ = entry_.matched(contact);
};

INSTANTIATE_TEST_SUITE_P(Friction, AgainstCvode,
                         testing::Range(std::size_t{0}, friction::dynamic_friction_models().size()),
                         [](const auto& which) {
                           return friction::dynamic_friction_models()[which.param].name;
                         });

// CVODE's own error at its tolerance of 1e-10 is up to 2e-8 here.
constexpr double cvode_error = 5e-8;

TEST_P(AgainstCvode, InPresliding) { EXPECT_LT(apart(oscillation(6e-6)), cvode_error); }

// From unloaded into sliding at full speed within four samples, where the error is largest, and
// through reversals, where it is a hundredth of that.
TEST_P(AgainstCvode, InSliding) {
  if (entry_.traits.is_random) return;  // tens of thousands of bonds snap: minutes of CVODE
  constexpr double promised = 1e-5;
  EXPECT_LT(apart(oscillation(3e-4)), promised);
}

// Speeds at start, middle and end of alternating sign: there and back within one interval.
TEST(FrictionResponse, CutsAnIntervalAtEachOfTwoReversals) {
  const auto dahl = friction::dynamic_friction_model("dahl").matched(contact);
  const simulate::HarmonicMotion motion = simulate::HarmonicMotion::sine(0, 2e-5, 10);
  constexpr double start_s = 0.02;
  constexpr double interval_s = 0.07;
  ASSERT_GT(motion.speed(start_s), 0);
  ASSERT_LT(motion.speed(start_s + interval_s / 2), 0);
  ASSERT_GT(motion.speed(start_s + interval_s), 0);
  const auto torque_after = [&](std::size_t steps) {
    std::vector<double> state = dahl->unloaded();
    std::vector<double> torque(steps + 1);
    simulate::friction_response(*dahl, motion, start_s, interval_s / static_cast<double>(steps),
                                state, torque);
    return torque.back();
  };
  // Forth a little, back all the way, and forth again, which ends above zero; the sum of the ways
  // is backward and would end at -0.95. What is left is each piece's way by Simpson's rule.
  EXPECT_GT(torque_after(1000), 0.1 * contact.coulomb_Nm);
  EXPECT_NEAR(torque_after(1), torque_after(1000), 0.01 * contact.coulomb_Nm);
}

TEST(FrictionResponse, IsTheSameInOnePassOrTwo) {
  const auto gms = friction::dynamic_friction_model("gms").matched(contact);
  const simulate::HarmonicMotion motion = oscillation(3e-4);
  std::vector<double> whole(samples);
  std::vector<double> state = gms->unloaded();
  simulate::friction_response(*gms, motion, 0, dt_s, state, whole);
  constexpr std::size_t cut = 300;
  std::vector<double> first(cut + 1);
  std::vector<double> second(samples - cut);
  std::vector<double> resumed = gms->unloaded();
  simulate::friction_response(*gms, motion, 0, dt_s, resumed, first);
  simulate::friction_response(*gms, motion, cut * dt_s, dt_s, resumed, second);
  for (std::size_t i = 0; i < samples; ++i) {
    EXPECT_NEAR(whole[i], i < cut ? first[i] : second[i - cut], 1e-12) << i;
  }
}

TEST(FrictionResponse, RefusesWhatCannotBe) {
  const auto gms = friction::dynamic_friction_model("gms").matched(contact);
  const simulate::HarmonicMotion motion = oscillation(3e-4);
  std::vector<double> torque(2);
  std::vector<double> state = gms->unloaded();
  std::vector<double> shorter(state.size() - 1);
  EXPECT_THROW(simulate::friction_response(*gms, motion, 0, 0, state, torque),
               std::invalid_argument);
  EXPECT_THROW(simulate::friction_response(*gms, motion, 0, dt_s, shorter, torque),
               std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::friction_response_test
