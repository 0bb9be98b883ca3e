// Ramps that contradict the loops: the loops' level is withdrawn, and nothing that was to be said
// of it is said.

#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "calibration/calibration_json.h"
#include "identify/identify.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::contradicting_ramps_test {
namespace {

using method::hysteresis::LuGreParameterName;

/// The ramps of a joint that sticks twice as hard as the one that made the loops.
joint::Dataset loops_and_contradicting_ramps(double largest_torque_Nm) {
  simulate::Scenario loops = test::noisy_paper_joint(3);
  loops.rough_sweep.reset();
  loops.precise_sweep.reset();
  loops.constant_speed.reset();
  simulate::Scenario ramps = loops;
  ramps.oscillation.reset();
  friction::LuGreFriction::Parameters contact = test::paper_contact().parameters();
  contact.coulomb_Nm *= 2;
  contact.static_Nm *= 2;
  ramps.presliding = std::make_shared<friction::LuGreFriction>(contact);
  simulate::BreakAwayExperiment slow;
  slow.centre_rad = test::true_q_peak_rad() + std::numbers::pi / 2;  // gravity is nothing there
  slow.rate_Nm_s = 0.2;
  slow.largest_torque_Nm = largest_torque_Nm;
  slow.repeats = 3;
  ramps.break_away = slow;
  joint::Dataset dataset = simulate::simulated_dataset(loops);
  for (joint::Recording& ramp : simulate::simulated_dataset(ramps).recordings) {
    dataset.recordings.push_back(std::move(ramp));
  }
  return dataset;
}

calibration::Calibration identified(const joint::Dataset& dataset) {
  identify::IdentifyOptions options;
  options.truth_runs = 2;
  return identify::identify(dataset, options);
}

const calibration::QuantityVerdict& break_away_verdict(const calibration::Calibration& c) {
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    if (q.quantity == joint::Quantity::break_away_torque) return q;
  }
  throw std::logic_error("no verdict on the break-away torque");
}

TEST(ContradictingRamps, TheLevelHasNoNumberNoIntervalAndAReason) {
  const calibration::Calibration c = identified(loops_and_contradicting_ramps(2.5));
  ASSERT_TRUE(c.lugre && c.lugre->converged);
  EXPECT_FALSE(c.lugre->shown(LuGreParameterName::static_torque));
  // What they do not contradict stays, with a number of its own.
  const auto stiffness = c.lugre->shown(LuGreParameterName::bristle_stiffness);
  ASSERT_TRUE(stiffness);
  EXPECT_LE(stiffness->low, 465.42);
  EXPECT_GE(stiffness->high, 465.42);
  // The break-away torque is that of the ramps, which end 0.7 % below it.
  const calibration::QuantityVerdict& q = break_away_verdict(c);
  ASSERT_TRUE(q.estimate);
  EXPECT_NEAR(q.estimate->value, 2 * 0.88437633, 0.03);
}

TEST(ContradictingRamps, TheJsonSaysWhy) {
  const std::string text =
      calibration::calibration_json(identified(loops_and_contradicting_ramps(2.5)), {});
  EXPECT_EQ(text.find('\0'), std::string::npos);
  const nlohmann::json lugre = nlohmann::json::parse(text)["friction"]["lugre"];
  EXPECT_TRUE(lugre["static_Nm"]["motor"].is_null());
  for (const nlohmann::json& p : lugre["parameters"]) {
    if (p["name"] != "static_Nm") continue;
    EXPECT_FALSE(p["shown"].get<bool>());
    EXPECT_NE(p["why_not"].get<std::string>().find("the loops creep"), std::string::npos);
    EXPECT_FALSE(p["experiment"].get<std::string>().empty());
  }
}

TEST(ContradictingRamps, RampsThatNeverSlideLeaveNoNumberAtAll) {
  const calibration::Calibration c = identified(loops_and_contradicting_ramps(1.6));
  ASSERT_EQ(c.break_away.censored, c.break_away.ramps.size());
  EXPECT_FALSE(c.lugre->shown(LuGreParameterName::static_torque));
  const calibration::QuantityVerdict& q = break_away_verdict(c);
  EXPECT_FALSE(q.estimate);
  EXPECT_EQ(q.verdict, calibration::Verdict::not_identifiable);
  ASSERT_FALSE(q.reasons.empty());
  EXPECT_NE(wording::words(q.reasons.front()).find("without sliding"), std::string::npos)
      << wording::words(q.reasons.front());
}

}  // namespace
}  // namespace tribolog::contradicting_ramps_test
