// What every dynamic model must do, and what each must show that claims it.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "friction/model_runs.h"
#include "wording/words.h"

namespace tribolog::every_model_test {
namespace {

using test::Specimen;

const friction::ContactParameters contact;

class EveryModel : public testing::TestWithParam<std::size_t> {
 protected:
  const friction::FrictionModelEntry& entry_ = friction::dynamic_friction_models()[GetParam()];
};

std::string name_of(const testing::TestParamInfo<std::size_t>& info) {
  return friction::dynamic_friction_models()[info.param].name;
}

INSTANTIATE_TEST_SUITE_P(Friction, EveryModel,
                         testing::Range(std::size_t{0}, friction::dynamic_friction_models().size()),
                         name_of);

/// An independent way through a motion: Runge-Kutta on rates(), with settle() after each step.
std::vector<double> by_rates(const friction::DynamicFriction& model, const simulate::Motion& motion,
                             double dt, int substeps, std::size_t samples) {
  std::vector<double> y = model.unloaded();
  const std::size_t n = y.size();
  std::vector<double> k1(n), k2(n), k3(n), k4(n), at(n), torque(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    if (i > 0) {
      const double h = dt / substeps;
      for (int s = 0; s < substeps; ++s) {
        const double t = static_cast<double>(i - 1) * dt + s * h;
        const auto step = [&](double share, const std::vector<double>& k) {
          for (std::size_t j = 0; j < n; ++j) at[j] = y[j] + share * h * k[j];
        };
        model.rates(y, motion.speed(t), k1);
        step(0.5, k1);
        model.rates(at, motion.speed(t + h / 2), k2);
        step(0.5, k2);
        model.rates(at, motion.speed(t + h / 2), k3);
        step(1.0, k3);
        model.rates(at, motion.speed(t + h), k4);
        for (std::size_t j = 0; j < n; ++j) y[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
        model.settle(y, motion.speed(t + h));
      }
    }
    torque[i] = model.torque_Nm(y, motion.speed(static_cast<double>(i) * dt));
  }
  return torque;
}

TEST_P(EveryModel, IsMadeAgainFromItsNamedParameters) {
  const auto model = entry_.matched(contact);
  EXPECT_EQ(model->name(), entry_.name);
  const friction::NamedParameters values = model->named_parameters();
  EXPECT_EQ(values, entry_.matched_parameters(contact));
  const auto again = entry_.make(values);
  EXPECT_EQ(again->named_parameters(), values);
  EXPECT_EQ(test::under_sine(*again, 1e-4, 1.0, 100, 2),
            test::under_sine(*model, 1e-4, 1.0, 100, 2));
}

TEST_P(EveryModel, HasWordsForItsNameSourceAndParameters) {
  EXPECT_FALSE(wording::words_for("friction_model", entry_.name).empty());
  EXPECT_FALSE(wording::words_for("friction_source", entry_.name).empty());
  for (const friction::NamedParameter& one : entry_.parameters) {
    EXPECT_FALSE(wording::words_for("parameter." + entry_.name, one.key).empty()) << one.key;
  }
}

// Each parameter has a key of its own that reaches the model, and no other.
TEST_P(EveryModel, EveryNamedParameterCounts) {
  const friction::NamedParameters values = entry_.matched_parameters(contact);
  const auto model = entry_.make(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    friction::NamedParameters changed = values;
    // A zero leaves its term out.
    if (auto* number = std::get_if<double>(&changed[i].value)) {
      *number = *number == 0 ? 0.01 : 0.99 * *number;
    }
    if (auto* count = std::get_if<std::uint64_t>(&changed[i].value)) *count += 1;
    if (auto* elements = std::get_if<std::vector<friction::MaxwellElement>>(&changed[i].value)) {
      for (friction::MaxwellElement& one : *elements) one.stiffness_Nm_rad *= 0.99;
    }
    if (values[i].key == "static_Nm" || values[i].key == "stiction_gain") {
      std::get<double>(changed[i].value) *= 1.02;  // not below the Coulomb torque
    }
    // A stroke into sliding, fast enough for the Stribeck curve, lag and damping to be felt.
    EXPECT_NE(test::under_sine(*entry_.make(changed), 1e-4, 5.0, 200, 2),
              test::under_sine(*model, 1e-4, 5.0, 200, 2))
        << values[i].key;
  }
}

TEST_P(EveryModel, RefusesNamesAndKindsItDoesNotHave) {
  EXPECT_THROW((void)entry_.make({{"colour", false, 1.0}}), std::invalid_argument);
  friction::NamedParameters values = entry_.matched_parameters(contact);
  values.back().value = std::vector<friction::MaxwellElement>{{1.0, 1.0}};
  EXPECT_THROW((void)entry_.make(values), std::invalid_argument);
}

TEST_P(EveryModel, SlidesAlikeAfterAnyRestUnlessItRemembersRest) {
  if (entry_.traits.is_random) return;
  const auto after = [&](double rest_s) {
    test::Specimen one(entry_, contact);
    one.move(1e-3, 0.002);
    one.rest(rest_s);
    return one.move(1e-3, 0.002);
  };
  const double difference_Nm = after(10.0) - after(0.01);
  constexpr double forgotten_Nm = 1e-9;
  if (entry_.traits.remembers_rest) {
    EXPECT_GT(difference_Nm, 0.01);
  } else {
    EXPECT_NEAR(difference_Nm, 0, forgotten_Nm);
  }
}

TEST_P(EveryModel, SlidesSteadilyOnItsStaticCurve) {
  for (const double speed : {-0.01, -0.0005, 0.0002, 0.001, 0.003, 0.05}) {
    test::Specimen s(entry_);
    s.rest(1e7);  // static friction of some models rises with the time at rest
    double torque = 0;
    if (entry_.traits.is_random) {
      constexpr int readings = 2000;
      s.move(std::copysign(1e-3, speed), std::abs(speed));
      for (int i = 0; i < readings; ++i) {
        torque += s.move(std::copysign(2e-6, speed), std::abs(speed)) / readings;
      }
      EXPECT_NEAR(torque, s.model().steady_torque_Nm(speed), 0.02) << speed;
    } else {
      torque = s.move(std::copysign(0.01, speed), std::abs(speed), 1e-5);
      EXPECT_NEAR(torque, s.model().steady_torque_Nm(speed), 1e-6) << speed;
    }
  }
  EXPECT_EQ(test::Specimen(entry_).model().steady_torque_Nm(0), 0);
}

TEST_P(EveryModel, SteadyCurveHasTheMatchedCoulombTorqueAndIsOdd) {
  const auto model = entry_.matched(contact);
  const double fast = 0.1;
  const double viscous = contact.viscous_Nms_rad * fast;
  EXPECT_NEAR(model->steady_torque_Nm(fast) - viscous, contact.coulomb_Nm, 1e-3);
  const double slow = model->steady_torque_Nm(1e-7);
  const double expected = entry_.traits.stribeck ? contact.static_Nm : contact.coulomb_Nm;
  EXPECT_NEAR(slow, expected, 1e-3);
  for (const double speed : {1e-5, 1e-3, 0.1}) {
    EXPECT_DOUBLE_EQ(model->steady_torque_Nm(-speed), -model->steady_torque_Nm(speed));
  }
}

// Its own steps against Runge-Kutta in steps a thousand times finer, over reversals.
TEST_P(EveryModel, AdvancesAsItsRatesSay) {
  const auto model = entry_.matched(contact);
  std::size_t looked_at = 0;
  for (const double amplitude : {3e-6, 3e-5}) {
    const simulate::HarmonicMotion motion = simulate::HarmonicMotion::sine(0, amplitude, 5.0);
    constexpr std::size_t samples = 121;
    constexpr double dt = 1.0 / (5.0 * 80);
    std::vector<double> torque(samples);
    std::vector<double> state = model->unloaded();
    simulate::friction_response(*model, motion, 0, dt, state, torque);
    const std::vector<double> fine = by_rates(*model, motion, dt, 4000, samples);
    for (std::size_t i = 0; i < samples; ++i) {
      // At a reversal a discontinuous model may be read on either side.
      const double speed = motion.speed(static_cast<double>(i) * dt);
      if (std::abs(speed) < 1e-3 * amplitude * 31) continue;
      ++looked_at;
      const double allowed = entry_.traits.is_random ? 0.02 : 2e-3;
      EXPECT_NEAR(torque[i], fine[i], allowed * contact.static_Nm) << i << " of " << amplitude;
    }
  }
  EXPECT_GT(looked_at, 0U);
}

TEST_P(EveryModel, DoesNotDependOnTheStepsItIsAdvancedIn) {
  if (entry_.traits.is_random) return;
  test::Specimen fine(entry_);
  test::Specimen coarse(entry_);
  for (const double way : {2.3e-5, -7e-6, 3e-6, -4e-5}) {
    const double a = fine.move(way, 0.0007, 1e-8);
    const double b = coarse.move(way, 0.0007, 1e-6);
    EXPECT_NEAR(a, b, 1e-4) << way;
  }
}

TEST_P(EveryModel, IsTheSameForwardAndBackward) {
  if (entry_.traits.is_random) return;
  test::Specimen forward(entry_);
  test::Specimen backward(entry_);
  for (const double way : {1e-5, -2e-6, 5e-5, -3e-5}) {
    EXPECT_DOUBLE_EQ(forward.move(way, 0.001), -backward.move(-way, 0.001));
  }
}

TEST_P(EveryModel, LosesEnergyInEveryClosedLoop) {
  const auto model = entry_.matched(contact);
  constexpr int samples = 2000;
  for (const double amplitude : {2e-7, 3e-6, 2e-5, 1e-3}) {
    for (const double frequency : {0.1, 10.0}) {
      const auto torque = test::under_sine(*model, amplitude, frequency, samples, 4);
      double work = 0;
      for (std::size_t i = torque.size() - samples; i < torque.size(); ++i) {
        const auto angle = [&](std::size_t k) {
          return amplitude * std::sin(2 * std::numbers::pi * static_cast<double>(k) / samples);
        };
        work += (torque[i] + torque[i - 1]) / 2 * (angle(i) - angle(i - 1));
      }
      EXPECT_GE(work, -1e-9 * contact.static_Nm * amplitude) << amplitude << " at " << frequency;
    }
  }
}

TEST_P(EveryModel, BreaksAwayAboveCoulombIfItSaysSo) {
  test::Specimen s(entry_);
  const double speed = entry_.traits.rate_independent ? 0.01 : 1e-5;
  double peak = 0;
  for (int i = 0; i < 4000; ++i) {
    peak = std::max(peak, s.move(2e-8, speed, 2e-8) - contact.viscous_Nms_rad * speed);
  }
  if (entry_.traits.break_away) {
    EXPECT_NEAR(peak, contact.static_Nm, 0.05);
  } else if (!entry_.traits.is_random && !entry_.traits.stribeck) {
    EXPECT_LE(peak, contact.coulomb_Nm + 1e-9);
  }
}

TEST_P(EveryModel, IsElasticAtFirstIfItSaysSo) {
  if (!entry_.traits.presliding || entry_.traits.is_random) return;
  test::Specimen s(entry_);
  constexpr double small = 2e-8;                     // far below the sliding deflection of 1.5e-5
  const double torque = s.move(small, 1e-9, 1e-10);  // slowly: no torque of damping
  double stiffness = torque / small;
  if (entry_.name == "reset_integrator") stiffness /= contact.static_Nm / contact.coulomb_Nm;
  EXPECT_NEAR(stiffness / contact.stiffness_Nm_rad, 1, 0.01);
}

// From the outer curve back, and forth to where it turned: an inner loop. With non-local memory the
// torque there is that of the turn, and the outer curve goes on as if nothing had been.
TEST_P(EveryModel, RemembersTheOuterCurveIfItSaysSo) {
  if (entry_.traits.is_random || !entry_.traits.presliding) return;
  constexpr double slow = 1e-7;  // no damping, no Stribeck effect
  constexpr double fine = 1e-9;
  test::Specimen with_loop(entry_);
  test::Specimen without(entry_);
  const double at_turn = with_loop.move(4e-6, slow, fine);
  without.move(4e-6, slow, fine);
  with_loop.move(-1e-6, slow, fine);
  const double returned = with_loop.move(1e-6, slow, fine);
  const double further = with_loop.move(2e-6, slow, fine) - without.move(2e-6, slow, fine);
  if (entry_.traits.non_local_memory) {
    EXPECT_NEAR(returned, at_turn, 2e-3);
    EXPECT_NEAR(further, 0, 2e-3);
  } else if (entry_.name == "lugre" || entry_.name == "dahl") {
    EXPECT_GT(std::abs(returned - at_turn), 0.01);
  }
}

// Speed up and down without reversal: the torque at falling speed is the smaller one.
TEST_P(EveryModel, LagsInSlidingIfItSaysSo) {
  const auto model = entry_.matched(contact);
  constexpr double frequency = 20;
  constexpr int samples = 400;
  // 0.0003 to 0.0021 of speed, around the Stribeck velocity
  class Pulsating final : public simulate::Motion {
   public:
    [[nodiscard]] double angle(double t) const override {
      return 0.0012 * t - 0.0009 / w * std::sin(w * t);
    }
    [[nodiscard]] double speed(double t) const override {
      return 0.0012 - 0.0009 * std::cos(w * t);
    }
    [[nodiscard]] double acceleration(double t) const override {
      return 0.0009 * w * std::sin(w * t);
    }

   private:
    double w = 2 * std::numbers::pi * frequency;
  } const motion;
  constexpr int periods = 40;
  std::vector<double> torque(periods * samples + 1);
  std::vector<double> state = model->unloaded();
  simulate::friction_response(*model, motion, 0, 1 / (frequency * samples), state, torque);
  double rising = 0;
  double falling = 0;
  for (int i = 1; i < samples / 2; ++i) {
    rising += torque[static_cast<std::size_t>((periods - 1) * samples + i)];
    falling += torque[static_cast<std::size_t>(periods * samples - i)];
  }
  if (entry_.traits.lag) {
    EXPECT_GT(rising - falling, 0.0005 * samples / 2);
  } else if (entry_.traits.rate_independent && !entry_.traits.is_random) {
    EXPECT_NEAR(rising, falling, 1e-6 * samples);
  }
}

TEST_P(EveryModel, DependsOnTheWayAloneIfItSaysSo) {
  friction::ContactParameters dry;
  dry.viscous_Nms_rad = 0;
  test::Specimen slow(entry_, dry);
  test::Specimen fast(entry_, dry);
  double largest = 0;
  for (const double way : {4e-6, -9e-6, 3e-5, -2e-6, 1e-5}) {
    largest = std::max(largest, std::abs(slow.move(way, 1e-5) - fast.move(way, 0.01)));
  }
  if (entry_.traits.rate_independent) {
    EXPECT_LT(largest, 1e-9);
  } else {
    EXPECT_GT(largest, 1e-3);
  }
}

TEST(FrictionCatalogue, NamesAreUniqueAndFound) {
  for (const friction::FrictionModelEntry& one : friction::dynamic_friction_models()) {
    EXPECT_EQ(&friction::dynamic_friction_model(one.name), &one);
  }
  EXPECT_THROW(friction::dynamic_friction_model("lugré"), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::every_model_test
