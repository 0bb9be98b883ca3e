// The known-truth check: what is right comes back, what is wrong is caught.

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "statistics/random_stream.h"
#include "study/small_scenario.h"
#include "support/paper_joint.h"
#include "truth/identified_joint.h"
#include "truth/truth_check.h"
#include "verdict/judge.h"
#include "wording/words.h"

namespace tribolog::known_truth_test {
namespace {

using calibration::ReadingName;

calibration::Calibration plain(const joint::Dataset& dataset, std::uint64_t seed) {
  identify::IdentifyOptions options;
  options.seed = seed;
  options.threads = 1;
  return identify::identify(dataset, options);
}

calibration::TruthCheckResult checked(const joint::Dataset& dataset, std::size_t runs) {
  return truth::check_known_truth(dataset, plain(dataset, 1), plain, {runs, 1, 0});
}

TEST(KnownTruth, PapersJointComesBackWithoutNoise) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::paper_joint());
  const calibration::TruthCheckResult check = checked(dataset, 3);
  EXPECT_EQ(check.torque_step_Nm, 0);
  EXPECT_LT(check.white_Nm, 1e-6);
  EXPECT_TRUE(check.findings.empty());
  for (const ReadingName name :
       {ReadingName::midline, ReadingName::fit, ReadingName::model, ReadingName::q_peak,
        ReadingName::bristle_stiffness, ReadingName::static_torque, ReadingName::asperity_torque,
        ReadingName::viscous_power}) {
    const calibration::ReturnedQuantity* q = check.find(name);
    ASSERT_NE(q, nullptr) << to_string(name);
    EXPECT_NEAR(q->came_back / q->put_in, 1, 2e-4) << to_string(name);
  }
}

TEST(KnownTruth, PapersJointComesBackInRealisticNoise) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(5));
  constexpr std::size_t runs = 12;
  const calibration::TruthCheckResult check = checked(dataset, runs);
  // What method.md section 8 lays on.
  EXPECT_NEAR(check.white_Nm, 0.02, 0.0005);
  EXPECT_NEAR(check.torque_step_Nm, 0.005, 1e-9);
  EXPECT_EQ(check.ripple_Nm, 0);
  EXPECT_TRUE(check.findings.empty()) << wording::words(check.findings.front().finding);
  std::size_t inside = 0;
  std::size_t found = 0;
  for (const calibration::ReturnedQuantity& q : check.quantities) {
    EXPECT_TRUE(q.comes_back) << to_string(q.name);
    inside += q.inside;
    found += q.found;
  }
  EXPECT_GT(static_cast<double>(inside) / static_cast<double>(found), 0.88);
  EXPECT_NEAR(check.find(ReadingName::midline)->came_back, check.find(ReadingName::midline)->put_in,
              5e-4 * test::true_gravity_Nm);
}

TEST(KnownTruth, ThreadsChangeNoNumber) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::small_scenario());
  const calibration::Calibration c = plain(dataset, 1);
  const calibration::TruthCheckResult one = truth::check_known_truth(dataset, c, plain, {4, 9, 1});
  const calibration::TruthCheckResult three =
      truth::check_known_truth(dataset, c, plain, {4, 9, 3});
  ASSERT_EQ(one.quantities.size(), three.quantities.size());
  for (std::size_t i = 0; i < one.quantities.size(); ++i) {
    EXPECT_EQ(one.quantities[i].in_half_widths, three.quantities[i].in_half_widths);
  }
}

TEST(KnownTruth, OfTheChainIsThatOfWholeIdentifications) {
  // The chain makes its simulations go through the compared stages alone.
  const joint::Dataset dataset = simulate::simulated_dataset(test::small_scenario());
  identify::IdentifyOptions options;
  options.truth_runs = 4;
  const calibration::TruthCheckResult of_chain = identify::identify(dataset, options).truth_check;
  const calibration::TruthCheckResult of_whole = checked(dataset, 4);
  ASSERT_FALSE(of_whole.quantities.empty());
  ASSERT_EQ(of_chain.quantities.size(), of_whole.quantities.size());
  for (std::size_t i = 0; i < of_whole.quantities.size(); ++i) {
    const calibration::ReturnedQuantity& a = of_chain.quantities[i];
    const calibration::ReturnedQuantity& b = of_whole.quantities[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.came_back, b.came_back) << to_string(a.name);
    EXPECT_EQ(a.half_width, b.half_width) << to_string(a.name);
    EXPECT_EQ(a.in_half_widths, b.in_half_widths) << to_string(a.name);
  }
}

TEST(KnownTruth, AWrongTruthIsCaught) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::small_scenario());
  truth::IdentifiedJoint joint = truth::identified_joint(dataset, plain(dataset, 1));
  for (truth::Reading& reading : joint.put_in) {
    if (reading.name != ReadingName::midline && reading.name != ReadingName::bristle_stiffness)
      continue;
    reading.estimate = statistics::scaled(reading.estimate, 1.05);
  }
  const calibration::TruthCheckResult check = truth::check_known_truth(joint, plain, {5, 1, 0});
  EXPECT_FALSE(check.find(ReadingName::midline)->comes_back);
  EXPECT_FALSE(check.find(ReadingName::bristle_stiffness)->comes_back);
  EXPECT_TRUE(check.find(ReadingName::model)->comes_back);
  ASSERT_EQ(check.findings.size(), 2U);
  EXPECT_NE(wording::words(check.findings[0].finding).find("mid-line"), std::string::npos)
      << wording::words(check.findings[0].finding);
  EXPECT_NE(wording::words(check.findings[0].finding).find("0 of 5"), std::string::npos)
      << wording::words(check.findings[0].finding);
}

TEST(KnownTruth, AWrongStageIsCaught) {
  // A chain whose angles are off by a degree finds neither its angle nor, by that much,
  // anything else to complain of.
  const joint::Dataset dataset = simulate::simulated_dataset(test::small_scenario());
  const auto wrong = [](const joint::Dataset& simulated, std::uint64_t seed) {
    calibration::Calibration c = plain(simulated, seed);
    if (c.q_peak_rad) {
      constexpr double off = 0.0175;
      c.q_peak_rad->value += off;
      c.q_peak_rad->low += off;
      c.q_peak_rad->high += off;
    }
    return c;
  };
  const calibration::TruthCheckResult check =
      truth::check_known_truth(dataset, plain(dataset, 1), wrong, {5, 1, 0});
  EXPECT_FALSE(check.find(ReadingName::q_peak)->comes_back);
  EXPECT_TRUE(check.find(ReadingName::model)->comes_back);
}

TEST(KnownTruth, AChainThatFindsNothingIsCaught) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::small_scenario());
  const auto blind = [](const joint::Dataset&, std::uint64_t) {
    return calibration::Calibration();
  };
  const calibration::TruthCheckResult check =
      truth::check_known_truth(dataset, plain(dataset, 1), blind, {3, 1, 0});
  ASSERT_FALSE(check.quantities.empty());
  EXPECT_EQ(check.findings.size(), check.quantities.size());
  EXPECT_NE(wording::words(check.findings[0].finding).find("not found in any of 3"),
            std::string::npos);
}

TEST(KnownTruth, ASweepAloneIsChecked) {
  simulate::Scenario scenario = test::small_scenario();
  scenario.oscillation.reset();
  const calibration::TruthCheckResult check = checked(simulate::simulated_dataset(scenario), 4);
  EXPECT_NE(check.find(ReadingName::model), nullptr);
  EXPECT_NE(check.find(ReadingName::q_peak), nullptr);
  EXPECT_EQ(check.find(ReadingName::midline), nullptr);
  EXPECT_TRUE(check.findings.empty());
}

TEST(KnownTruth, AnOscillationAloneIsChecked) {
  simulate::Scenario scenario = test::small_scenario();
  scenario.rough_sweep.reset();
  const calibration::TruthCheckResult check = checked(simulate::simulated_dataset(scenario), 4);
  EXPECT_NE(check.find(ReadingName::midline), nullptr);
  EXPECT_NE(check.find(ReadingName::static_torque), nullptr);
  EXPECT_EQ(check.find(ReadingName::q_peak), nullptr);
  EXPECT_TRUE(check.findings.empty());
}

TEST(KnownTruth, WithoutGravityItSaysWhyNothingIsSimulated) {
  simulate::Scenario scenario = test::small_scenario();
  scenario.rough_sweep.reset();
  scenario.oscillation->cycles = 1;
  joint::Dataset dataset = simulate::simulated_dataset(scenario);
  for (double& q : dataset.recordings.front().q_rad) q = 0;  // a constant joint
  const calibration::TruthCheckResult check = checked(dataset, 4);
  EXPECT_TRUE(check.quantities.empty());
  ASSERT_EQ(check.left_out.size(), 1U);
  EXPECT_NE(wording::words(check.left_out[0]).find("no gravity torque"), std::string::npos);
}

TEST(KnownTruth, WhatDoesNotComeBackMakesItsQuantityDoubtful) {
  calibration::Calibration c = plain(simulate::simulated_dataset(test::paper_joint()), 1);
  EXPECT_EQ(verdict::judge(c).verdict, calibration::Verdict::usable);
  const auto verdict_on = [&](joint::Quantity quantity) {
    for (const calibration::QuantityVerdict& q : verdict::judge(c).quantities) {
      if (q.quantity == quantity) return q.verdict;
    }
    return calibration::Verdict::not_identifiable;
  };
  c.truth_check.findings = {
      {ReadingName::midline, Statement::verbatim("the mid-line does not come back")}};
  // The mass is then that of the model of sweeps and runs, which does not rest on the mid-line.
  const calibration::Judgement by_model = verdict::judge(c);
  EXPECT_TRUE(
      by_model.find(joint::Quantity::surrogate_mass)->estimate->method.is("interval.of_model"));
  EXPECT_EQ(verdict_on(joint::Quantity::cog_angle), calibration::Verdict::usable);
  const auto model = std::exchange(c.model, {});
  const auto recommended =
      std::exchange(c.selection.recommended, method::hysteresis::Estimator::midline);
  EXPECT_EQ(verdict_on(joint::Quantity::surrogate_mass), calibration::Verdict::doubtful);
  EXPECT_EQ(verdict::judge(c).verdict, calibration::Verdict::doubtful);
  EXPECT_NE(std::find(verdict::judge(c).findings.begin(), verdict::judge(c).findings.end(),
                      Statement::verbatim("the mid-line does not come back")),
            verdict::judge(c).findings.end());
  // An estimator that nothing rests on is told of and lowers nothing.
  c.model = model;
  c.selection.recommended = recommended;
  c.truth_check.findings = {{ReadingName::B, Statement::verbatim("point B does not come back")}};
  EXPECT_EQ(verdict::judge(c).verdict, calibration::Verdict::usable);
}

TEST(KnownTruth, IdentifyMakesItWhereAsked) {
  const joint::Dataset dataset = simulate::simulated_dataset(test::small_scenario());
  identify::IdentifyOptions options;
  EXPECT_EQ(identify::identify(dataset, options).truth_check.runs, 0U);
  options.truth_runs = 2;
  const calibration::Calibration c = identify::identify(dataset, options);
  EXPECT_EQ(c.truth_check.runs, 2U);
  EXPECT_EQ(c.truth_check.find(ReadingName::midline)->found, 2U);
}

TEST(FoundNoise, RippleIsFoundWithItsPeriods) {
  simulate::Scenario scenario = test::noisy_paper_joint(3);
  scenario.noise.ripple = {{0.03, 1, 0.4}, {0.02, 6, -1.0}};
  scenario.oscillation.reset();
  scenario.constant_speed.reset();
  scenario.precise_sweep.reset();
  const joint::Dataset dataset = simulate::simulated_dataset(scenario);
  const calibration::Calibration c = plain(dataset, 1);
  const std::vector<simulate::Noise::Ripple> ripple =
      truth::ripple_of(dataset, c.rough, c.curves.rough);
  ASSERT_EQ(ripple.size(), 2U);
  EXPECT_NEAR(ripple[0].periods_per_turn, 1, 1e-3);
  EXPECT_NEAR(ripple[0].amplitude_Nm, 0.03, 0.002);
  EXPECT_NEAR(ripple[0].phase_rad, 0.4, 0.05);
  EXPECT_NEAR(ripple[1].periods_per_turn, 6, 1e-3);
  EXPECT_NEAR(ripple[1].amplitude_Nm, 0.02, 0.002);
  EXPECT_NEAR(ripple[1].phase_rad, -1.0, 0.05);
}

TEST(FoundNoise, WhiteNoiseIsFoundUnderASlope) {
  statistics::RandomStream random(5, 0);
  std::vector<double> torque;
  for (int i = 0; i < 20000; ++i) {
    const double slow = 3 * std::sin(1e-3 * i);
    const double jump = i == 10000 ? 50 : 0;  // one outlier
    torque.push_back(slow + jump + 0.02 * random.normal());
  }
  EXPECT_NEAR(truth::white_torque_Nm(torque), 0.02, 0.001);
  EXPECT_EQ(truth::white_torque_Nm({1, 2, 3}), 0);
}

}  // namespace
}  // namespace tribolog::known_truth_test
