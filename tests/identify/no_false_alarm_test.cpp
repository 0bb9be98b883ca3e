// A false alarm is as bad as a miss: the examples raise only what is true of them.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "ingest/manifest/scenario_file.h"
#include "method/checks/data_checks.h"
#include "simulate/simulate_joint.h"
#include "support/check_findings.h"
#include "support/paper_joint.h"

namespace tribolog::no_false_alarm_test {
namespace {

using test::findings_of;

std::vector<std::string> findings_in_example(const std::string& name) {
  const joint::Dataset dataset = simulate::simulated_dataset(ingest::manifest::read_scenario(
      std::string(TRIBOLOG_SOURCE_DIR) + "/examples/paper/" + name));
  return test::findings_of(identify::identify(dataset).data_checks);
}

TEST(NoFalseAlarm, InThePapersJointCleanAndNoisy) {
  EXPECT_EQ(findings_in_example("scenario.toml"), std::vector<std::string>{});
  EXPECT_EQ(findings_in_example("scenario_noise.toml"), std::vector<std::string>{});
}

TEST(NoFalseAlarm, RippleAtOnePositionIsAllThatIsWrongWithTheRipplingOne) {
  EXPECT_EQ(findings_in_example("scenario_ripple.toml"), std::vector<std::string>{"torque_ripple"});
}

TEST(NoFalseAlarm, OverTwentySeedsOfNoise) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(seed));
    EXPECT_EQ(test::findings_of(method::checks::check_recordings(dataset)),
              std::vector<std::string>{})
        << seed;
  }
}

}  // namespace
}  // namespace tribolog::no_false_alarm_test
