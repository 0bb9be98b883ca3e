// Friction in each direction: known truths, whether it differs by friction itself or by an offset.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/requirements.h"
#include "identify/identify.h"
#include "simulate/simulate_joint.h"
#include "support/paper_joint.h"

namespace tribolog::friction_direction_test {
namespace {

using calibration::FrictionAtSpeed;

/// Nothing is stated of effects.
std::vector<FrictionAtSpeed> friction_of(const simulate::Scenario& scenario) {
  joint::Dataset d = simulate::simulated_dataset(scenario);
  d.manifest.effects = {};
  return identify::identify(d).judgement.friction_at_speed;
}

simulate::Scenario noisy(unsigned seed) { return test::noisy_paper_joint(seed); }

/// Friction of the same joint without anything that differs: noise is the same.
struct Pair {
  std::vector<FrictionAtSpeed> even;
  std::vector<FrictionAtSpeed> uneven;
};

Pair pair_of(simulate::Scenario scenario, double asymmetry, double offset_Nm) {
  Pair pair;
  pair.even = friction_of(scenario);
  scenario.effects.direction_asymmetry = asymmetry;
  scenario.effects.torque_offset_Nm = offset_Nm;
  pair.uneven = friction_of(scenario);
  return pair;
}

void expect_close(const Pair& pair, double asymmetry, double offset_Nm) {
  ASSERT_EQ(pair.even.size(), pair.uneven.size());
  ASSERT_GT(pair.even.size(), 20U);
  for (std::size_t k = 0; k < pair.even.size(); ++k) {
    const FrictionAtSpeed& f = pair.uneven[k];
    const double there_Nm = pair.even[k].torque_Nm.value;
    const double forward_Nm = there_Nm * (1 + asymmetry) + offset_Nm;
    const double backward_Nm = there_Nm * (1 - asymmetry) - offset_Nm;
    const statistics::Estimate forward = present(f.forward_Nm);
    const statistics::Estimate backward = present(f.backward_Nm);
    const std::string at = std::to_string(f.speed_rad_s) + " rad/s";
    EXPECT_NEAR(forward.value, forward_Nm, 0.01 * there_Nm) << at;
    EXPECT_NEAR(backward.value, backward_Nm, 0.01 * there_Nm) << at;
    EXPECT_LE(forward.low, forward_Nm) << at;
    EXPECT_GE(forward.high, forward_Nm) << at;
    EXPECT_LE(backward.low, backward_Nm) << at;
    EXPECT_GE(backward.high, backward_Nm) << at;
    // An interval that holds all is no answer.
    EXPECT_LT(forward.half_width(), 0.05 * there_Nm) << at;
    EXPECT_NEAR((forward.value + backward.value) / 2, f.torque_Nm.value, 0.001 * there_Nm) << at;
  }
}

TEST(FrictionByDirection, FrictionThatDiffersIsFoundInBoth) {
  expect_close(pair_of(noisy(3), 0.04, 0), 0.04, 0);
}

TEST(FrictionByDirection, AnOffsetCountsInBoth) {
  expect_close(pair_of(noisy(4), 0, 0.03), 0, 0.03);
}

TEST(FrictionByDirection, WithoutADifferenceBothAreTheMean) {
  expect_close(pair_of(noisy(5), 0, 0), 0, 0);
}

TEST(FrictionByDirection, AStatedAbsenceMakesThemTheMean) {
  const calibration::Calibration c =
      identify::identify(simulate::simulated_dataset(test::noisy_paper_joint(6)));
  ASSERT_FALSE(c.judgement.friction_at_speed.empty());
  for (const FrictionAtSpeed& f : c.judgement.friction_at_speed) {
    EXPECT_DOUBLE_EQ(present(f.forward_Nm).value, f.torque_Nm.value);
    EXPECT_DOUBLE_EQ(present(f.backward_Nm).low, f.torque_Nm.low);
  }
}

}  // namespace
}  // namespace tribolog::friction_direction_test
