#include "exports/simulation/simulation_files.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/dataset/dataset_file.h"
#include "ingest/manifest/scenario_file.h"
#include "robot/joint_under_test.h"
#include "simulate/simulate_joint.h"

namespace tribolog::simulation_files_test {
namespace {

using test::TemporaryDirectory;

simulate::Scenario example(const std::string& name) {
  return ingest::manifest::read_scenario(std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/" +
                                         name);
}

class WriteSimulation : public testing::TestWithParam<const char*> {};

TEST_P(WriteSimulation, ComesBackBitForBit) {
  const test::TemporaryDirectory directory;
  const simulate::Scenario scenario = example(GetParam());
  const std::vector<joint::Recording> recordings = simulate::simulate_joint(scenario);
  exports::simulation::write_simulation(scenario, recordings, directory.path("out/simulated"));
  const joint::Dataset d =
      ingest::dataset::read_dataset(directory.path("out/simulated/dataset.toml"));
  ASSERT_EQ(d.recordings.size(), recordings.size());
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const joint::Recording& written = recordings[i];
    const joint::Recording& read = d.recordings[i];
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.role, written.role);
    EXPECT_EQ(read.t_s, written.t_s) << written.name;
    EXPECT_EQ(read.q_rad, written.q_rad) << written.name;
    EXPECT_EQ(read.dq_rad_s, written.dq_rad_s) << written.name;
    EXPECT_EQ(read.torque_Nm, written.torque_Nm) << written.name;
    EXPECT_EQ(read.z_rad, written.z_rad) << written.name;
    EXPECT_EQ(read.dz_rad_s, written.dz_rad_s) << written.name;
    EXPECT_TRUE(read.skipped.empty()) << written.name;
  }
  EXPECT_TRUE(d.notes.empty());
  EXPECT_TRUE(std::filesystem::exists(directory.path("out/simulated/truth.json")));
  EXPECT_EQ(directory.contents("out/simulated/am100ib.toml"), scenario.robot_description_text);
  ASSERT_NE(d.robot, nullptr);
  EXPECT_EQ(d.robot->under_test.joint().name, scenario.joint);
}

INSTANTIATE_TEST_SUITE_P(Examples, WriteSimulation,
                         testing::Values("scenario.toml", "scenario_noise.toml",
                                         "scenario_ripple.toml"));

simulate::Scenario small_scenario() {
  simulate::Scenario s = example("scenario.toml");
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.constant_speed.reset();
  return s;
}

TEST(WriteSimulationTwice, GivesTheSameBytes) {
  const test::TemporaryDirectory directory;
  const simulate::Scenario s = small_scenario();
  exports::simulation::write_simulation(s, simulate::simulate_joint(s), directory.path("a"));
  exports::simulation::write_simulation(s, simulate::simulate_joint(s), directory.path("b"));
  for (const char* name : {"/dataset.toml", "/truth.json", "/oscillation.csv"}) {
    EXPECT_EQ(directory.contents(std::string("a") + name),
              directory.contents(std::string("b") + name));
  }
}

TEST(WriteSimulationRefusal, OfADirectoryThatCannotBeMade) {
  const test::TemporaryDirectory directory;
  const std::string file = directory.file("file", "");
  const simulate::Scenario s = small_scenario();
  EXPECT_EQ(test::refusal_of<OutputError>([&] {
              exports::simulation::write_simulation(s, simulate::simulate_joint(s), file);
              return 0;
            }),
            file + ": cannot create the directory: Not a directory");
}

TEST(WriteSimulationRefusal, OfNamesThatLeaveTheDirectory) {
  const test::TemporaryDirectory directory;
  const simulate::Scenario s = small_scenario();
  std::vector<joint::Recording> recordings = simulate::simulate_joint(s);
  recordings[0].name = "../escaped.csv";
  EXPECT_THROW(exports::simulation::write_simulation(s, recordings, directory.path("out")),
               std::invalid_argument);
  EXPECT_EQ(directory.entries(), 0U);
}

}  // namespace
}  // namespace tribolog::simulation_files_test
