// Set points are read back by the project's own reader, and are the plan's motion.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "exports/experiment/plan_files.h"
#include "ingest/text/csv_reader.h"
#include "plan/paper_facts.h"

namespace tribolog::test::set_points_test {
namespace {

ingest::log::LogTable read_back(const plan::ExperimentPlan& plan) {
  return ingest::text::read_csv(
      exports::experiment::set_points_csv(plan), "setpoints.csv",
      {{"t_s"}, {"q_rad"}, {"dq_rad_s"}, {"torque_mode"}, {"ramp_torque_Nm"}});
}

TEST(SetPoints, ComeBackAsThePlansMotion) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts(), {0.25});
  const ingest::log::LogTable table = read_back(plan);
  const auto& t = table.columns[0].values;
  ASSERT_GT(table.rows, 1000U);
  EXPECT_EQ(t.front(), 0);
  EXPECT_EQ(t.back(), plan.duration_s());
  for (std::size_t i = 0; i < table.rows; i += 37) {
    EXPECT_EQ(table.columns[1].values[i], plan.angle_rad(t[i]));
    EXPECT_EQ(table.columns[2].values[i], plan.speed_rad_s(t[i]));
  }
  for (const ingest::log::LogColumn& column : table.columns) EXPECT_EQ(column.gaps, 0U);
}

TEST(SetPoints, KeepTheLimitsFromRowToRow) {
  const joint::JointFacts f = paper_facts();
  const plan::ExperimentPlan plan = plan::plan_experiment(f, {0.25});
  const ingest::log::LogTable table = read_back(plan);
  const auto& t = table.columns[0].values;
  const auto& q = table.columns[1].values;
  const auto& dq = table.columns[2].values;
  for (std::size_t i = 0; i + 1 < table.rows; ++i) {
    ASSERT_GE(q[i], f.lowest_rad);
    ASSERT_LE(q[i], f.highest_rad);
    const double dt = t[i + 1] - t[i];
    ASSERT_GT(dt, 0);
    ASSERT_LE(std::abs(q[i + 1] - q[i]), 1.000001 * f.speed_limit_rad_s * dt);
    ASSERT_LE(std::abs(dq[i + 1] - dq[i]), 1.000001 * f.acceleration_limit_rad_s2 * dt);
    // The angle follows the mean of the speeds about it.
    ASSERT_NEAR(q[i + 1] - q[i], (dq[i] + dq[i + 1]) / 2 * dt,
                f.acceleration_limit_rad_s2 * dt * dt);
  }
  EXPECT_EQ(dq.front(), 0);
  EXPECT_NEAR(dq.back(), 0, 1e-12);
}

TEST(SetPoints, TheTorqueLeadsInTheRampsAlone) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts(), {0.25});
  const ingest::log::LogTable table = read_back(plan);
  std::size_t ramps = 0;
  double largest = 0;
  for (std::size_t i = 1; i < table.rows; ++i) {
    const bool leads = table.columns[3].values[i] == 1;
    ramps += leads && table.columns[3].values[i - 1] == 0 ? 1 : 0;
    if (leads) {
      EXPECT_EQ(table.columns[2].values[i], 0);
    } else {
      EXPECT_EQ(table.columns[4].values[i], 0);
    }
    largest = std::max(largest, std::abs(table.columns[4].values[i]));
  }
  EXPECT_EQ(ramps, plan.part(joint::Role::break_away).recordings);
  // Past the break-away torque of 0.884 N·m, within what the limit leaves.
  EXPECT_GT(largest, 1.2 * 0.884);
  EXPECT_LT(largest, 12 - 3.883);
}

TEST(SetPoints, OfNothingAreAHeader) {
  plan::ExperimentPlan plan = plan::plan_experiment(paper_facts());
  plan.segments.clear();
  EXPECT_EQ(exports::experiment::set_points_csv(plan),
            "t_s,q_rad,dq_rad_s,torque_mode,ramp_torque_Nm\n");
}

}  // namespace
}  // namespace tribolog::test::set_points_test
