// The bootstrap of a whole chain: the same on any number of threads, silent where it has nothing to
// draw, and together with the cross-checks honest about a disagreement.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "calibration/calibration_json.h"
#include "identify/identify.h"
#include "support/paper_joint.h"

namespace tribolog::resampling_test {
namespace {

using method::hysteresis::Estimator;

calibration::Calibration with_threads(const joint::Dataset& dataset, std::size_t threads,
                                      std::uint64_t seed) {
  identify::IdentifyOptions options;
  options.resamples = 200;
  options.threads = threads;
  options.seed = seed;
  return identify::identify(dataset, options);
}

TEST(Resampling, NumbersDoNotDependOnThreads) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(7));
  const std::string one = calibration::calibration_json(with_threads(dataset, 1, 1), {});
  EXPECT_EQ(calibration::calibration_json(with_threads(dataset, 2, 1), {}), one);
  EXPECT_EQ(calibration::calibration_json(with_threads(dataset, 5, 1), {}), one);
  EXPECT_NE(calibration::calibration_json(with_threads(dataset, 1, 2), {}), one);
}

TEST(Resampling, WithoutResamplesClosedFormsAreStated) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(7));
  identify::IdentifyOptions options;
  options.resamples = 0;
  const calibration::Calibration c = identify::identify(dataset, options);
  EXPECT_TRUE(c.intervals.bands.empty());
  for (const method::intervals::TwoIntervals& q : c.intervals.quantities)
    EXPECT_FALSE(q.bootstrap) << q.name;
  ASSERT_NE(c.intervals.find("mass_kg.midline")->stated(), nullptr);
  EXPECT_GE(c.cross_checks.checks.size(), 7U);
}

TEST(Resampling, OfNothingIsNothing) {
  const calibration::Calibration c = identify::identify(joint::Dataset{});
  EXPECT_TRUE(c.intervals.quantities.empty());
  EXPECT_TRUE(c.cross_checks.checks.empty());
}

TEST(Resampling, AnErrorOfGravityIsCommonToTheRunsOfACurve) {
  // Ripple at the loop moves the whole curve: the band is as wide as that, at every speed.
  simulate::Scenario s = test::noisy_paper_joint(3);
  s.noise.ripple = {{0.02, 1.0, 0.4}};
  const joint::Dataset dataset = simulate::simulated_dataset(s);
  const calibration::Calibration c = with_threads(dataset, 0, 1);
  const method::intervals::CurveBand& loop = *c.intervals.band(Estimator::midline);
  const method::intervals::CurveBand& sweep = *c.intervals.band(Estimator::sweep);
  for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
    EXPECT_GT(loop.high_Nm[i] - loop.low_Nm[i], 0.03) << i;
    EXPECT_LT(sweep.high_Nm[i] - sweep.low_Nm[i], 0.01) << i;
  }
  // The parameters of the curve do not suffer: both directions together cancel it.
  const statistics::Estimate& speed = c.friction.waiboer->stribeck_speed_rad_s;
  EXPECT_LT(speed.half_width() / speed.value, 0.05);
}

TEST(CrossChecks, EveryWayFindsTheMassWithoutNoise) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::paper_joint());
  const calibration::Calibration c = identify::identify(dataset);
  ASSERT_GE(c.cross_checks.checks.size(), 8U);
  for (const method::intervals::CrossCheck& check : c.cross_checks.checks) {
    // The linear regression lacks the Stribeck effect.
    const double allowed = check.method == method::intervals::GravityMethod(
                                               method::selection::IndependentMethod::classical)
                               ? 2e-3
                               : 1e-4;
    EXPECT_NEAR(check.mass_kg.value / test::true_surrogate_mass_kg, 1, allowed)
        << method::intervals::to_string(check.method);
  }
  EXPECT_FALSE(c.cross_checks.doubtful);
  ASSERT_TRUE(c.cross_checks.classical);
  // It leaves what the Stribeck effect and the bent viscous law are.
  EXPECT_GT(c.cross_checks.classical->residual_Nm, 0.03);
}

TEST(CrossChecks, ClassicalRegressionKnowsTheNoiseThatItDoesNotReach) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(2));
  const calibration::Calibration c = identify::identify(dataset);
  ASSERT_TRUE(c.cross_checks.classical);
  const method::selection::ClassicalRegression& classical = *c.cross_checks.classical;
  // 0.02 N·m white, in means of 20 samples.
  EXPECT_NEAR(classical.row_noise_Nm, 0.02 / std::sqrt(20.0), 0.001);
  EXPECT_GT(classical.residual_Nm, 10 * classical.row_noise_Nm);
  // The textbook interval does not see that the model is wrong.
  EXPECT_GT(classical.gravity_Nm.half_width(), 5 * classical.textbook_gravity_Nm.half_width());
}

TEST(CrossChecks, AnOffsetOfTheTorqueSensorIsTakenOffTheLoop) {
  // The sweep's regression has an offset and is not moved; the mid-line would take it for gravity.
  joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(5));
  dataset.manifest.effects = {};
  for (joint::Recording& r : dataset.recordings) {
    for (double& torque : r.torque_Nm) torque += 0.05;
  }
  const calibration::Calibration c = identify::identify(dataset);
  const calibration::QuantityVerdict& gravity = *c.judgement.find(joint::Quantity::gravity_torque);
  EXPECT_LE(gravity.estimate->low, test::true_gravity_Nm);
  EXPECT_GE(gravity.estimate->high, test::true_gravity_Nm);
  const method::model::ModelEffect* offset = c.model.find("offset");
  ASSERT_TRUE(offset != nullptr && offset->coefficient);
  EXPECT_LT(offset->coefficient->low, 0.05);
  EXPECT_GT(offset->coefficient->high, 0.05);
  const auto disagrees = [&](Estimator method) {
    for (const method::intervals::CrossCheck& check : c.cross_checks.checks) {
      if (check.method == method::intervals::GravityMethod(method)) return check.disagrees;
    }
    return false;
  };
  EXPECT_FALSE(disagrees(Estimator::sweep));
  EXPECT_FALSE(disagrees(Estimator::AB));
  EXPECT_FALSE(disagrees(Estimator::fit));
}

}  // namespace
}  // namespace tribolog::resampling_test
