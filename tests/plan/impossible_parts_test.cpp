// What the limits do not allow is said with its number and what would help, not planned.

#include <gtest/gtest.h>

#include "joint/degrees.h"
#include "plan/experiment_plan.h"
#include "plan/paper_facts.h"
#include "wording/words.h"

namespace tribolog::test::impossible_parts_test {
namespace {

void expect_words(const plan::PlannedPart& part, plan::PartState state, const std::string& why,
                  const std::string& help) {
  const std::string said = wording::words(part.why);
  const std::string helpful = wording::words(part.help);
  EXPECT_EQ(part.state, state) << said;
  EXPECT_NE(said.find(why), std::string::npos) << said;
  EXPECT_NE(helpful.find(help), std::string::npos) << helpful;
  EXPECT_EQ(part.recordings == 0, state == plan::PartState::impossible);
}

TEST(ImpossibleParts, RangeTooSmallForASweep) {
  joint::JointFacts f = paper_facts();
  f.lowest_rad = -30 * joint::rad_per_degree;
  f.highest_rad = -15 * joint::rad_per_degree;
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  expect_words(plan.part(joint::Role::rough_sweep), plan::PartState::impossible, "14.7°",
               "wider angle limits");
  EXPECT_EQ(plan.part(joint::Role::oscillation).state, plan::PartState::planned);
}

TEST(ImpossibleParts, EncoderTooCoarseForPresliding) {
  joint::JointFacts f = paper_facts();
  f.encoder_counts_per_turn = 4096;
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  // 0.02 rad of the motor in steps of 2 pi/4096: 13.
  expect_words(plan.part(joint::Role::oscillation), plan::PartState::impossible,
               "4096 counts per motor turn give 13 steps", "counts or more");
  expect_words(plan.part(joint::Role::break_away), plan::PartState::impossible, "encoder steps",
               "finer encoder");
  EXPECT_EQ(plan.part(joint::Role::rough_sweep).state, plan::PartState::planned);
  // What is said to help does.
  f.encoder_counts_per_turn = 4096 * 50 / 13.0 * 1.01;
  EXPECT_EQ(plan::plan_experiment(f).part(joint::Role::oscillation).state,
            plan::PartState::planned);
}

TEST(ImpossibleParts, SpeedLimitBelowTheStribeckRange) {
  joint::JointFacts f = paper_facts();
  f.speed_limit_rad_s = 0.08;  // 8 rad/s at the motor, ws is 5
  expect_words(plan::plan_experiment(f).part(joint::Role::constant_speed), plan::PartState::limited,
               "1.5 times the Stribeck velocity of 5 rad/s", "15 rad/s");
  f.speed_limit_rad_s = 0.01;  // below a fifth of it, twice
  expect_words(plan::plan_experiment(f).part(joint::Role::constant_speed),
               plan::PartState::impossible, "0.95 rad/s at the motor", "speed limit");
}

TEST(ImpossibleParts, TorqueLimitBelowGravity) {
  joint::JointFacts f = paper_facts();
  f.torque_limit_Nm = 3;
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  ASSERT_FALSE(plan.remarks.empty());
  EXPECT_TRUE(plan.remarks.front().is("plan.torque_holds_stretch"));
  EXPECT_TRUE(wording::words(plan.remarks.front()).starts_with("the torque limit of 3 N·m"));
  for (const joint::Role role :
       {joint::Role::precise_sweep, joint::Role::oscillation, joint::Role::break_away}) {
    expect_words(plan.part(role), plan::PartState::impossible, "−22.23°", "a lighter load");
  }
}

TEST(ImpossibleParts, TorqueLimitTooSmallForARamp) {
  joint::JointFacts f = paper_facts();
  f.torque_limit_Nm = 5.1;  // gravity 3.88, break-away 0.88: 0.96 N·m are left
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  EXPECT_EQ(plan.part(joint::Role::oscillation).state, plan::PartState::planned);
  expect_words(plan.part(joint::Role::break_away), plan::PartState::impossible, "leaves 0.962 N·m",
               "a lighter load");
}

TEST(ImpossibleParts, PeakOutsideTheRange) {
  joint::JointFacts f = paper_facts();
  f.q_peak_rad = 80 * joint::rad_per_degree;
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  expect_words(plan.part(joint::Role::rough_sweep), plan::PartState::limited, "80.00°",
               "includes the peak");
  expect_words(plan.part(joint::Role::precise_sweep), plan::PartState::impossible,
               "outside the usable range", "wider angle limits");
}

TEST(ImpossibleParts, DirectDriveCannotSpreadOverAMotorTurn) {
  joint::JointFacts f = paper_facts();
  f.gear_ratio = 1;
  f.speed_limit_rad_s = 20;
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  expect_words(plan.part(joint::Role::oscillation), plan::PartState::limited, "remains in the mean",
               "wider range");
}

TEST(ImpossibleParts, TooLittleTimeIsSaid) {
  joint::JointFacts f = paper_facts();
  f.time_budget_s = 60;
  const plan::ExperimentPlan plan = plan::plan_experiment(f);
  ASSERT_EQ(plan.remarks.size(), 1U);
  const std::string remark = wording::words(plan.remarks.front());
  EXPECT_NE(remark.find("more than the time budget of 60 s"), std::string::npos) << remark;
}

}  // namespace
}  // namespace tribolog::test::impossible_parts_test
