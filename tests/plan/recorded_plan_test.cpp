// From set points to truth: a joint follows the plan, its log and the plan's manifest are read, and
// what was simulated comes back.

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/temporary_directory.h"
#include "exports/experiment/plan_files.h"
#include "exports/simulation/simulation_files.h"
#include "identify/identify.h"
#include "ingest/dataset/dataset_file.h"
#include "ingest/manifest/scenario_file.h"
#include "plan/paper_facts.h"
#include "plan/simulated_plan.h"
#include "simulate/drive_noise.h"
#include "truth/readings.h"
#include "wording/words.h"

namespace tribolog::test::recorded_plan_test {
namespace {

using calibration::ReadingName;

constexpr double rate_Hz = 1000;

simulate::Scenario paper_joint_with_noise() {
  return ingest::manifest::read_scenario(std::string(TRIBOLOG_SOURCE_DIR) +
                                         "/examples/paper/scenario_ripple.toml");
}

/// The log of the joint following the plan, on disk beside the plan's manifest.
joint::Dataset recorded(const plan::ExperimentPlan& plan, const simulate::Scenario& joint,
                        const TemporaryDirectory& directory) {
  joint::Recording log = plan::simulate_plan(plan, joint, rate_Hz);
  simulate::add_drive_noise(log, joint.noise, joint.gear_ratio, rate_Hz, 0);
  (void)directory.file(plan::planned_log_name, exports::simulation::recording_csv(log));
  return ingest::dataset::read_dataset(
      directory.file("dataset.toml", exports::experiment::plan_dataset_toml(plan)));
}

TEST(RecordedPlan, EveryRecordingIsCutOutOfTheLog) {
  const TemporaryDirectory directory;
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts(), {0.25});
  const joint::Dataset dataset = recorded(plan, paper_joint_with_noise(), directory);
  for (const plan::PlannedPart& part : plan.parts) {
    EXPECT_EQ(dataset.with_role(part.role).size(), part.recordings) << joint::to_string(part.role);
  }
  std::size_t k = 0;
  for (const plan::PlannedSegment& s : plan.segments) {
    if (!s.role) continue;
    const joint::Recording& r = dataset.recordings[k++];
    EXPECT_NEAR(r.t_s.front(), s.from_s, 1 / rate_Hz);
    EXPECT_NEAR(r.t_s.back(), s.to_s, 1 / rate_Hz);
  }
  EXPECT_EQ(dataset.manifest.robot, plan.joint.facts.robot);
  EXPECT_EQ(dataset.manifest.drive.gear_ratio(), 100);
}

TEST(RecordedPlan, OfARobotIsCutOutOfEachJointsLog) {
  const TemporaryDirectory directory;
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts(), {0.25});
  plan::ExperimentPlan second = plan;
  second.joint.facts.joint = "wrist";
  const joint::Recording log = plan::simulate_plan(plan, paper_joint_with_noise(), rate_Hz);
  for (const char* name : {"elbow", "wrist"}) {
    std::filesystem::create_directory(directory.path(name));
    (void)directory.file(std::string(name) + "/" + plan::planned_log_name,
                         exports::simulation::recording_csv(log));
  }
  const std::string manifest = directory.file(
      "dataset.toml", exports::experiment::plan_robot_toml({{"elbow", &plan}, {"wrist", &second}}));
  const std::vector<std::string> joints = ingest::dataset::joints_of_robot(manifest);
  ASSERT_EQ(joints, (std::vector<std::string>{plan.joint.facts.joint, "wrist"}));
  for (const std::string& joint : joints) {
    const joint::Dataset dataset = ingest::dataset::read_dataset(manifest, joint);
    EXPECT_EQ(dataset.manifest.joint, joint);
    EXPECT_EQ(dataset.manifest.robot, plan.joint.facts.robot);
    for (const plan::PlannedPart& part : plan.parts)
      EXPECT_EQ(dataset.with_role(part.role).size(), part.recordings) << joint;
  }
}

struct Truth {
  ReadingName name;
  double value;
};

std::vector<Truth> truths_of(const simulate::Scenario& joint) {
  constexpr double gravity_Nm = 3.88318571;
  constexpr double static_Nm = 0.88437633;
  return {{ReadingName::midline, gravity_Nm},       {ReadingName::fit, gravity_Nm},
          {ReadingName::model, gravity_Nm},         {ReadingName::q_peak, joint.load.q_peak_rad()},
          {ReadingName::bristle_stiffness, 465.42}, {ReadingName::static_torque, static_Nm},
          {ReadingName::asperity_torque, 0.8844},   {ReadingName::stribeck_speed, 5},
          {ReadingName::viscous_coefficient, 0.12}, {ReadingName::viscous_power, 0.6}};
}

TEST(RecordedPlan, GivesTheTruthWithinItsIntervals) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts());
  simulate::Scenario joint = paper_joint_with_noise();
  identify::IdentifyOptions options;
  std::size_t stated = 0;
  std::size_t held = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const TemporaryDirectory directory;
    joint.noise.seed = seed;
    const joint::Dataset dataset = recorded(plan, joint, directory);
    const calibration::Calibration c = identify::identify(dataset, options);
    const std::vector<truth::Reading> found = truth::readings_of(c);
    for (const Truth& truth : truths_of(joint)) {
      const truth::Reading* r = truth::find_reading(found, truth.name);
      ASSERT_NE(r, nullptr) << to_string(truth.name) << ", seed " << seed;
      ++stated;
      held += r->estimate.low <= truth.value && truth.value <= r->estimate.high ? 1 : 0;
      constexpr double largest_error = 0.01;  // 1 % of the truth
      EXPECT_NEAR(r->estimate.value, truth.value, largest_error * std::abs(truth.value))
          << to_string(truth.name) << ", seed " << seed;
    }
    ASSERT_TRUE(c.break_away.mean_Nm);
    EXPECT_EQ(c.break_away.censored, 0U);
    EXPECT_TRUE(c.break_away.is_level);
    EXPECT_NEAR(c.break_away.mean_Nm->value, 0.88437633, 1.5 * c.break_away.mean_Nm->half_width());
    EXPECT_NE(c.judgement.verdict, calibration::Verdict::not_identifiable)
        << wording::words(c.judgement.sentence);
  }
  EXPECT_EQ(stated, 30U);
  // Of 30 intervals of 95 %, fewer than 25 hold the truth once in 300 times.
  EXPECT_GE(held, 25U);
}

// A log starts somewhere in the motion of a contact that has slid: the manifest's windows hold the
// whole cycles alone.
TEST(RecordedPlan, OscillationsAreWholeCyclesOfASine) {
  const plan::ExperimentPlan plan = plan::plan_experiment(paper_facts(), {0.25});
  const joint::Recording log = plan::simulate_plan(plan, paper_joint_with_noise(), rate_Hz);
  std::size_t looked_at = 0;
  for (const simulate::IdealRecording& one : plan::cut_by_plan(plan, log, rate_Hz)) {
    const joint::Recording& r = one.recording;
    if (r.role != joint::Role::oscillation) continue;
    ++looked_at;
    const double cycles = (r.t_s.back() - r.t_s.front()) * plan.frequency_Hz;
    EXPECT_NEAR(cycles, std::round(cycles), 2 * plan.frequency_Hz / rate_Hz);
    EXPECT_NEAR(r.q_rad.back(), r.q_rad.front(), 0.02 * plan.amplitude_rad);
  }
  EXPECT_GT(looked_at, 0U);
}

TEST(RecordedPlan, NeedsAContactThatYields) {
  simulate::Scenario rigid = paper_joint_with_noise();
  rigid.sliding = nullptr;
  EXPECT_THROW(plan::simulate_plan(plan::plan_experiment(paper_facts()), rigid, rate_Hz),
               std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::test::recorded_plan_test
