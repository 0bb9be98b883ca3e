// The reference that needs no knowledge beforehand, against the true curve of a simulated joint.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "support/breadth.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::quality_without_truth_test {
namespace {

using method::selection::CurveReference;

/// Calibration of the same data without the true curve.
calibration::Calibration identify_blind(joint::Dataset dataset) {
  dataset.manifest.reference.reset();
  return identify::identify(dataset);
}

TEST(QualityWithoutTruth, ReferenceAgreesWithTheTrueCurveWithinItsInterval) {
  TRIBOLOG_EACH_NIGHT();
  const std::uint64_t seeds = test::seeds_of(5, 20);
  const friction::WaiboerFriction truth = test::paper_curve();
  int covered = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const calibration::Calibration c =
        identify_blind(simulate::simulated_dataset(test::noisy_paper_joint(seed)));
    ASSERT_EQ(c.quality.reference, CurveReference::direction_difference);
    for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
      const method::viscous::ConstantSpeedRun& run = c.viscous.runs[i];
      if (run.speed_rad_s < 0) continue;  // partners share one reference
      const double error = std::abs(c.quality.reference_Nm[i] - truth.torque_Nm(run.speed_rad_s));
      covered += error <= c.quality.reference_half_width_Nm[i];
      ++all;
      EXPECT_LT(error, 0.01) << run.speed_rad_s;  // 1 % of the friction, far below a candidate's
    }
  }
  RecordProperty("covered", covered);
  RecordProperty("all", all);
  EXPECT_GE(covered, 0.90 * all);
}

TEST(QualityWithoutTruth, ChoosesTheSameMassAndSaysHowFarItCanBeTrusted) {
  const std::uint64_t seeds = test::seeds_of(6, 20);
  int same = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(seed));
    const calibration::Calibration sighted = identify::identify(dataset);
    const calibration::Calibration blind = identify_blind(dataset);
    EXPECT_EQ(sighted.quality.reference, CurveReference::analytic);
    EXPECT_EQ(sighted.quality.reference_rms_percent, 0);
    EXPECT_EQ(sighted.selection.recommended, blind.selection.recommended);
    same += sighted.selection.paper_rule == blind.selection.paper_rule;
    EXPECT_GT(blind.quality.reference_rms_percent, 0);
    EXPECT_NE(wording::words(blind.quality.evidence).find("no evidence"), std::string::npos)
        << wording::words(blind.quality.evidence);
    for (const method::selection::QualityError& e : sighted.quality.errors) {
      const double other = blind.quality.find(e.estimator)->rms_percent;
      EXPECT_NEAR(other, e.rms_percent, std::max(0.05, 2 * blind.quality.reference_rms_percent));
    }
  }
  EXPECT_GE(same, 0.9 * static_cast<double>(seeds));
}

// The limit of the reference: it is the mean of both directions. An offset of the torque signal
// shifts every candidate by the same amount, and the model says so.
TEST(QualityWithoutTruth, AsymmetricFrictionIsSeenBesideIt) {
  constexpr double offset_Nm = 0.15;
  joint::Dataset dataset = simulate::simulated_dataset(test::noisy_paper_joint(5));
  dataset.manifest.effects = {};
  const calibration::Calibration even = identify_blind(dataset);
  for (joint::Recording& r : dataset.recordings) {
    for (double& torque : r.torque_Nm) torque += offset_Nm;
  }
  const calibration::Calibration odd = identify_blind(dataset);
  const method::model::ModelEffect* before = even.model.find("offset");
  const method::model::ModelEffect* found = odd.model.find("offset");
  ASSERT_TRUE(before != nullptr && found != nullptr);
  EXPECT_LT(before->largest_Nm.low, 0);
  EXPECT_LT(found->largest_Nm.low, offset_Nm);
  EXPECT_GT(found->largest_Nm.high, offset_Nm);
  EXPECT_LT(found->largest_Nm.half_width(), 0.5 * offset_Nm);
  for (std::size_t i = 0; i < even.quality.reference_Nm.size(); ++i) {
    // The inertia that is taken off the runs is the model's, which sees the offset, too.
    EXPECT_NEAR(odd.quality.reference_Nm[i], even.quality.reference_Nm[i], 1e-8);
  }
}

// Runs whose directions share no angle have no such reference.
TEST(QualityWithoutTruth, WithoutCommonAnglesItIsRefusedInWords) {
  joint::Dataset dataset = simulate::simulated_dataset(test::paper_joint());
  dataset.manifest.reference.reset();
  std::vector<joint::Recording> cut;
  for (const joint::Recording& r : dataset.recordings) {
    if (r.role != joint::Role::constant_speed) {
      cut.push_back(r);
      continue;
    }
    // The way back becomes a recording of its own, moved beyond the way there.
    const auto top = static_cast<std::size_t>(std::max_element(r.q_rad.begin(), r.q_rad.end()) -
                                              r.q_rad.begin());
    for (const bool back : {false, true}) {
      joint::Recording part;
      part.name = r.name;
      part.role = r.role;
      for (std::size_t i = back ? top : 0; i < (back ? r.size() : top); ++i) {
        part.t_s.push_back(r.t_s[i]);
        part.q_rad.push_back(r.q_rad[i] + (back ? 1.5 : 0.0));
        part.torque_Nm.push_back(r.torque_Nm[i]);
      }
      cut.push_back(std::move(part));
    }
  }
  dataset.recordings = std::move(cut);
  const calibration::Calibration c = identify::identify(dataset);
  EXPECT_EQ(c.quality.reference, CurveReference::none);
  EXPECT_NE(wording::words(c.quality.stage.reason).find("the directions share no angle"),
            std::string::npos)
      << wording::words(c.quality.stage.reason);
  EXPECT_NE(wording::words(c.quality.stage.reason).find("both directions over the same angles"),
            std::string::npos);
}

}  // namespace
}  // namespace tribolog::quality_without_truth_test
