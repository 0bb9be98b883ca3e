// What is absent makes the stages that need it say so; the rest still runs.

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "support/paper_joint.h"

namespace tribolog::missing_data_test {
namespace {

using method::hysteresis::Estimator;

void expect_every_gap_has_words(const calibration::Calibration& c) {
  for (const statistics::StageReport& stage : c.stages()) {
    EXPECT_FALSE(stage.name.empty());
    EXPECT_TRUE(stage.state == statistics::StageState::done || !stage.reason.empty()) << stage.name;
  }
}

TEST(MissingData, EverySubsetOfRolesRuns) {
  for (int subset = 0; subset < 16; ++subset) {
    simulate::Scenario s = test::paper_joint();
    if ((subset & 1) == 0) s.rough_sweep.reset();
    if ((subset & 2) == 0) s.precise_sweep.reset();
    if ((subset & 4) == 0) s.oscillation.reset();
    if ((subset & 8) == 0) s.constant_speed.reset();
    const joint::Dataset d = simulate::simulated_dataset(s);
    const calibration::Calibration c = identify::identify(d);
    expect_every_gap_has_words(c);
    const bool has_runs = (subset & 8) != 0;  // their angle travels: gravity shows in them too
    const bool has_sweep = (subset & 3) != 0 || has_runs;
    EXPECT_EQ(c.q_peak_rad.has_value(), has_sweep) << subset;
    const bool has_mass = (subset & 4) != 0 || (subset & 1) != 0 || has_runs;
    EXPECT_EQ(c.selection.recommended.has_value(), has_mass) << subset;
    // Loops are needed, and runs, for the curve; these confirm gravity in place of a sweep.
    EXPECT_EQ(c.judgement.verdict == calibration::Verdict::usable, (subset & 12) == 12) << subset;
    if (!has_sweep || !has_mass) {
      EXPECT_EQ(c.judgement.verdict, calibration::Verdict::not_identifiable) << subset;
    }
  }
}

TEST(MissingData, RecordingsOfARoleMayBeMany) {
  simulate::Scenario s = test::paper_joint();
  joint::Dataset d = simulate::simulated_dataset(s);
  const std::size_t once = d.recordings.size();
  for (std::size_t i = 0; i < once; ++i) d.recordings.push_back(d.recordings[i]);
  const calibration::Calibration c = identify::identify(d);
  EXPECT_NEAR(c.masses.find(Estimator::midline)->mass_kg.value, test::true_surrogate_mass_kg, 0.01);
  EXPECT_NEAR(c.q_peak_rad->value, test::true_q_peak_rad(), 1e-5);
  EXPECT_EQ(c.viscous.runs.size(), 80U);
}

}  // namespace
}  // namespace tribolog::missing_data_test
