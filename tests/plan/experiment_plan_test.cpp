// The plan of the paper's joint, and what more knowledge and more time change.

#include "plan/experiment_plan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "joint/degrees.h"
#include "plan/paper_facts.h"
#include "wording/words.h"

namespace tribolog::test::experiment_plan_test {
namespace {

double lowest(const plan::PlannedSegment& s) {
  double low = 1e9;
  for (int i = 0; i <= 1000; ++i) {
    low = std::min(low, s.motion->angle(s.motion->duration_s() * i / 1000));
  }
  return low;
}

const plan::PlannedSegment& first_of(const plan::ExperimentPlan& plan, joint::Role role) {
  for (const plan::PlannedSegment& s : plan.segments) {
    if (s.role == role) return s;
  }
  throw std::logic_error("no such segment");
}

TEST(PaperPlan, IsThePapersExperiment) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts());
  for (const plan::PlannedPart& part : plan.parts) {
    EXPECT_EQ(part.state, plan::PartState::planned)
        << joint::to_string(part.role) << ": " << wording::words(part.why);
  }
  EXPECT_TRUE(plan.remarks.empty());
  EXPECT_FALSE(plan.is_first_of_two());
  // Precise: one degree either side of the peak, as in the paper.
  const double peak = -22.23187 * joint::rad_per_degree;
  EXPECT_NEAR(lowest(first_of(plan, joint::Role::precise_sweep)), peak - joint::rad_per_degree,
              1e-9);
  // The amplitude that reproduces its Table 2: 1e-4 rad.
  EXPECT_NEAR(plan.amplitude_rad, 1e-4, 1e-6);
  EXPECT_DOUBLE_EQ(plan.frequency_Hz, 1);
}

TEST(PaperPlan, PositionsSpreadOverTheRipple) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts());
  ASSERT_GE(plan.positions_rad.size(), 8U);
  // The mean of a sine of each known period over the positions, at any phase, is nothing.
  for (const double periods : {1.0, 6.0}) {
    double cosine = 0;
    double sine = 0;
    for (const double q : plan.positions_rad) {
      cosine += std::cos(periods * 100 * q);
      sine += std::sin(periods * 100 * q);
    }
    EXPECT_LT(std::hypot(cosine, sine), 1e-9) << periods;
  }
}

// Eight positions would see ripple of eight periods as a constant.
TEST(PaperPlan, PositionsDoNotShareAPeriodOfTheRipple) {
  joint::JointFacts f = paper_facts();
  f.ripple_periods_per_turn = {1, 2, 4, 8, 24};
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  EXPECT_LT(plan.ripple_left_share, 0.01);
  for (const double periods : f.ripple_periods_per_turn) {
    EXPECT_NE(std::fmod(periods, static_cast<double>(plan.positions_rad.size())), 0);
  }
}

TEST(Plan, WithoutThePeakHoldsTheRoughSweepAndTheRuns) {
  const plan::ExperimentPlan plan = plan::plan_experiment(bare_facts());
  EXPECT_TRUE(plan.is_first_of_two());
  EXPECT_EQ(plan.part(joint::Role::rough_sweep).state, plan::PartState::planned);
  EXPECT_EQ(plan.part(joint::Role::constant_speed).state, plan::PartState::planned);
  for (const joint::Role role :
       {joint::Role::precise_sweep, joint::Role::oscillation, joint::Role::break_away}) {
    EXPECT_EQ(plan.part(role).state, plan::PartState::later);
    EXPECT_EQ(plan.part(role).recordings, 0U);
  }
}

TEST(Plan, HoldsThePartsThatAreAskedForAlone) {
  plan::PlanOptions options;
  options.roles =
      plan::roles_that_show({joint::Quantity::coulomb_torque, joint::Quantity::viscous_curve});
  EXPECT_EQ(options.roles, std::vector<joint::Role>{joint::Role::constant_speed});
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts(), options);
  for (const plan::PlannedPart& part : plan.parts) {
    const bool is_asked = part.role == joint::Role::constant_speed;
    EXPECT_EQ(part.state, is_asked ? plan::PartState::planned : plan::PartState::not_asked);
    EXPECT_EQ(part.recordings > 0, is_asked);
    EXPECT_TRUE(part.is_as_asked());
  }
  EXPECT_LT(plan.duration_s(), plan::plan_experiment(paper_facts()).duration_s() / 2);
  EXPECT_FALSE(plan.is_first_of_two());
}

TEST(Plan, ASlowJointsStribeckVelocityIsAssumedBelowItsSpeedLimit) {
  joint::JointFacts f = bare_facts();
  f.gear_ratio = 1;
  f.speed_limit_rad_s = 0.7;
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  EXPECT_NEAR(plan.joint.stribeck_speed_rad_s, 0.07, 1e-12);
  EXPECT_EQ(plan.part(joint::Role::constant_speed).state, plan::PartState::planned);
}

TEST(Plan, NamesWhatItAssumes) {
  const auto known = [](const plan::ExperimentPlan& plan) {
    return std::count_if(plan.joint.assumptions.begin(), plan.joint.assumptions.end(),
                         [](const plan::Assumption& a) { return a.is_known; });
  };
  EXPECT_EQ(known(plan::plan_experiment(bare_facts())), 0);
  const plan::ExperimentPlan paper = plan::plan_experiment(paper_facts());
  // All but the viscous coefficient, which no key states.
  EXPECT_EQ(known(paper), static_cast<long>(paper.joint.assumptions.size()) - 1);
}

// Where the deflection at break-away is a guess, one amplitude would be another.
TEST(Plan, TriesSeveralAmplitudesWhereTheStiffnessIsAssumed) {
  joint::JointFacts f = paper_facts();
  const std::size_t sure = plan::plan_experiment(f).part(joint::Role::oscillation).recordings;
  f.bristle_stiffness_Nm_rad.reset();
  EXPECT_EQ(plan::plan_experiment(f).part(joint::Role::oscillation).recordings, sure + 2);
}

TEST(Plan, EffortTakesTime) {
  double before = 0;
  for (const double effort : {0.25, 0.5, 1.0, 2.0, 4.0}) {
    const double duration = plan::plan_experiment(paper_facts(), {effort}).duration_s();
    EXPECT_GT(duration, 1.2 * before) << effort;
    before = duration;
  }
  EXPECT_THROW(plan::plan_experiment(paper_facts(), {0.0}), std::invalid_argument);
}

TEST(Plan, FillsTheTimeBudget) {
  joint::JointFacts f = paper_facts();
  for (const double budget : {300.0, 600.0, 1200.0}) {
    f.time_budget_s = budget;
    const double duration = plan::plan_experiment(f).duration_s();
    EXPECT_LE(duration, budget);
    EXPECT_GT(duration, 0.5 * budget);
  }
}

TEST(Plan, RefusesImpossibleFacts) {
  joint::JointFacts f = paper_facts();
  f.highest_rad = f.lowest_rad;
  EXPECT_THROW(plan::plan_experiment(f), std::invalid_argument);
  f = paper_facts();
  f.torque_limit_Nm = -1;
  EXPECT_THROW(plan::plan_experiment(f), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::test::experiment_plan_test
