// The scenario files of examples/ are the known truth of the tests: the two must not drift apart.

#include <gtest/gtest.h>

#include "ingest/manifest/scenario_file.h"
#include "simulate/simulate_joint.h"
#include "support/paper_joint.h"

namespace tribolog::scenario_of_examples_test {
namespace {

void expect_same(const simulate::Scenario& file, const simulate::Scenario& truth) {
  const std::vector<joint::Recording> a = simulate::simulate_joint(file);
  const std::vector<joint::Recording> b = simulate::simulate_joint(truth);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(a[k].size(), b[k].size()) << a[k].name;
    EXPECT_EQ(a[k].z_rad.empty(), b[k].z_rad.empty()) << a[k].name;
    for (std::size_t i = 0; i < a[k].size(); i += 37) {
      // Degrees come back from a decimal text: a unit in the last place may differ, and may tip
      // the quantisation of angle or torque by one step.
      ASSERT_NEAR(a[k].q_rad[i], b[k].q_rad[i], 1e-6) << a[k].name;
      ASSERT_NEAR(a[k].torque_Nm[i], b[k].torque_Nm[i], 0.0051) << a[k].name;
    }
  }
}

simulate::Scenario example(const std::string& name) {
  return ingest::manifest::read_scenario(std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/" +
                                         name);
}

TEST(ScenarioOfExamples, IdealDrive) { expect_same(example("scenario.toml"), test::paper_joint()); }

TEST(ScenarioOfExamples, RealisticNoise) {
  const simulate::Scenario file = example("scenario_noise.toml");
  expect_same(file, test::noisy_paper_joint(file.noise.seed));
}

TEST(ScenarioOfExamples, RippleIsTheNoisyOneWithRipple) {
  const simulate::Scenario file = example("scenario_ripple.toml");
  ASSERT_EQ(file.noise.ripple.size(), 2U);
  EXPECT_EQ(file.noise.ripple[0].periods_per_turn, 1);
  EXPECT_EQ(file.noise.ripple[1].periods_per_turn, 6);
  simulate::Scenario without = file;
  without.noise.ripple.clear();
  expect_same(without, test::noisy_paper_joint(file.noise.seed));
}

}  // namespace
}  // namespace tribolog::scenario_of_examples_test
