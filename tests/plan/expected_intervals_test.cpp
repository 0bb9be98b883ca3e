// What a plan says to expect, against what independent simulations of the same joint give.

#include "plan/expected_intervals.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "identify/identify.h"
#include "ingest/manifest/scenario_file.h"
#include "plan/paper_facts.h"
#include "plan/simulated_plan.h"
#include "simulate/simulate_joint.h"
#include "support/breadth.h"

namespace tribolog::test::expected_intervals_test {
namespace {

using calibration::ReadingName;

/// The paper's joint as its scenario has it, with its own friction and ripple, following the plan.
std::vector<std::vector<truth::Reading>> independent_runs(const plan::ExperimentPlan& plan,
                                                          std::size_t runs) {
  const simulate::Scenario joint = ingest::manifest::read_scenario(
      std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/scenario_ripple.toml");
  const std::vector<simulate::IdealRecording> ideal =
      plan::cut_by_plan(plan, plan::simulate_plan(plan, joint, 1000), 1000);
  std::vector<std::vector<truth::Reading>> found(runs);
  parallel_for(
      runs,
      [&](std::size_t run) {
        constexpr std::uint64_t far_seed = 7'000'000;
        simulate::Noise noise = joint.noise;
        noise.seed = far_seed + run;
        for (simulate::Noise::Ripple& r : noise.ripple)
          r.phase_rad += 2.399 * static_cast<double>(run + 1);
        identify::IdentifyOptions once;
        once.threads = 1;
        found[run] = truth::readings_of(
            identify::identify(simulate::simulated_dataset(
                                   joint, simulate::with_noise(ideal, noise, joint.gear_ratio)),
                               once));
      },
      0);
  return found;
}

double scatter_of(const std::vector<std::vector<truth::Reading>>& runs, ReadingName name) {
  std::vector<double> values;
  for (const auto& readings : runs) {
    if (const truth::Reading* r = truth::find_reading(readings, name))
      values.push_back(r->estimate.value);
  }
  double mean = 0;
  double squares = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) squares += std::pow(v - mean, 2);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

// Ten runs know a standard deviation to a factor of 1.5; closed forms are wide by up to two where
// few cycles or positions give their degrees of freedom.
constexpr double agreement = 3.5;

TEST(ExpectedIntervals, HoldTheTruthAndAgreeWithIndependentSimulations) {
  TRIBOLOG_EACH_NIGHT();
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts());
  const plan::ExpectedIntervals expected = plan::expect_intervals(plan, {8});
  EXPECT_NEAR(expected.find(ReadingName::midline)->truth, 3.88318571, 1e-9);
  ASSERT_NE(expected.find(ReadingName::break_away), nullptr);
  for (const plan::ExpectedInterval& e : expected.quantities) {
    // Of eight intervals of 95 %, fewer than five hold the truth once in 2,700 times.
    EXPECT_GE(e.inside, 5U) << to_string(e.name);
  }
  const auto runs = independent_runs(plan, 10);
  for (const ReadingName name :
       {ReadingName::midline, ReadingName::fit, ReadingName::model, ReadingName::q_peak,
        ReadingName::bristle_stiffness, ReadingName::static_torque, ReadingName::sweep_friction,
        ReadingName::stribeck_speed, ReadingName::viscous_coefficient, ReadingName::viscous_power,
        ReadingName::asperity_torque}) {
    const plan::ExpectedInterval* e = expected.find(name);
    ASSERT_NE(e, nullptr) << to_string(name);
    EXPECT_EQ(e->found, 8U) << to_string(name);
    const double scatter = 1.96 * scatter_of(runs, name);
    EXPECT_LT(e->half_width, agreement * scatter) << to_string(name);
    EXPECT_GT(e->half_width, scatter / agreement) << to_string(name);
  }
}

TEST(ExpectedIntervals, MoreTimeNarrowsThem) {
  TRIBOLOG_EACH_NIGHT();
  const std::size_t runs = test::seeds_of(2, 4);
  const plan::ExpectedIntervals little =
      plan::expect_intervals(plan::plan_experiment(paper_facts(), {0.3}), {runs});
  const plan::ExpectedIntervals much =
      plan::expect_intervals(plan::plan_experiment(paper_facts(), {1.5}), {runs});
  for (const ReadingName name : {ReadingName::midline, ReadingName::model, ReadingName::q_peak,
                                 ReadingName::bristle_stiffness, ReadingName::sweep_friction}) {
    EXPECT_LT(much.find(name)->half_width, 0.9 * little.find(name)->half_width) << to_string(name);
  }
}

TEST(ExpectedIntervals, AreTheSameOnAnyNumberOfCores) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts(), {0.25});
  const plan::ExpectedIntervals one = plan::expect_intervals(plan, {3, 5, 1});
  const plan::ExpectedIntervals two = plan::expect_intervals(plan, {3, 5, 2});
  ASSERT_EQ(one.quantities.size(), two.quantities.size());
  for (std::size_t i = 0; i < one.quantities.size(); ++i) {
    EXPECT_EQ(one.quantities[i].half_width, two.quantities[i].half_width);
    EXPECT_EQ(one.quantities[i].scatter, two.quantities[i].scatter);
  }
}

TEST(ExpectedIntervals, AFirstPlanExpectsWhatItCanShow) {
  const plan::ExpectedIntervals expected =
      plan::expect_intervals(plan::plan_experiment(bare_facts(), {0.25}), {2});
  EXPECT_NE(expected.find(ReadingName::q_peak), nullptr);
  EXPECT_NE(expected.find(ReadingName::stribeck_speed), nullptr);
  EXPECT_EQ(expected.find(ReadingName::midline), nullptr);
  EXPECT_EQ(expected.find(ReadingName::bristle_stiffness), nullptr);
}

TEST(ExpectedIntervals, NoneWithoutRunsOrRecordings) {
  EXPECT_TRUE(plan::expect_intervals(plan::plan_experiment(paper_facts()), {0}).quantities.empty());
}

}  // namespace
}  // namespace tribolog::test::expected_intervals_test
