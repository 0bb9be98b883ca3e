#include "method/selection/quality_errors.h"

#include <cmath>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::quality_errors_test {
namespace {

using method::hysteresis::Estimator;
using method::selection::CurveReference;

TEST(QualityErrors, HandWorkedPercentages) {
  method::viscous::ViscousCurvesResult v;
  method::viscous::ConstantSpeedRun run;
  run.torque_Nm = 4.0;
  run.speed_rad_s = 10;
  run.direction_difference_Nm = 0.5;
  v.runs = {run, run};
  v.runs[1].torque_Nm = 2.0;
  v.curves = {{Estimator::A, {0.54, 0.48}}};
  const method::selection::QualityErrorsResult q =
      method::selection::identify_quality_errors(v, nullptr);
  EXPECT_EQ(q.reference, CurveReference::direction_difference);
  ASSERT_EQ(q.errors.size(), 1U);
  EXPECT_NEAR(q.errors[0].percent[0], 1.0, 1e-12);
  EXPECT_NEAR(q.errors[0].percent[1], -1.0, 1e-12);
  EXPECT_NEAR(q.errors[0].rms_percent, 1.0, 1e-12);
}

/// A speed of a single pair has no interval: it made that of the whole reference infinite, and
/// every error "no evidence".
TEST(QualityErrors, TheReferenceIsJudgedByTheRunsWhoseIntervalIsKnown) {
  method::viscous::ViscousCurvesResult v;
  method::viscous::ConstantSpeedRun run;
  run.torque_Nm = 4.0;
  run.direction_difference_Nm = 0.5;
  run.direction_difference_half_width_Nm = 0.08;
  v.runs = {run, run};
  v.runs[1].direction_difference_half_width_Nm = INFINITY;
  v.curves = {{Estimator::A, {0.9, 0.9}}};
  method::selection::QualityErrorsResult q = method::selection::identify_quality_errors(v, nullptr);
  EXPECT_NEAR(q.reference_rms_percent, 2.0, 1e-12);
  EXPECT_TRUE(q.evidence.is("quality_errors.all_beyond_reference"));
  v.runs[0].direction_difference_half_width_Nm = NAN;
  q = method::selection::identify_quality_errors(v, nullptr);
  EXPECT_TRUE(std::isnan(q.reference_rms_percent));
  EXPECT_TRUE(q.evidence.empty());
}

TEST(QualityErrors, DirectionDifferenceRanksTheCandidatesAsTheTruthDoes) {
  joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  const calibration::Calibration with_truth = identify::identify(d);
  d.manifest.reference.reset();
  const calibration::Calibration without = identify::identify(d);
  EXPECT_EQ(with_truth.quality.reference, CurveReference::analytic);
  EXPECT_EQ(without.quality.reference, CurveReference::direction_difference);
  EXPECT_EQ(without.selection.paper_rule, Estimator::B);
  for (const method::selection::QualityError& e : with_truth.quality.errors) {
    ASSERT_NE(without.quality.find(e.estimator), nullptr);
    EXPECT_NEAR(without.quality.find(e.estimator)->rms_percent, e.rms_percent, 0.02);
  }
}

TEST(QualityErrors, RunsWithoutReferenceAreCountedAsLeftOut) {
  method::viscous::ViscousCurvesResult v;
  method::viscous::ConstantSpeedRun run;
  run.torque_Nm = 4.0;
  run.direction_difference_Nm = 0.5;
  v.runs = {run, run, run};
  v.runs[1].direction_difference_Nm = std::nan("");
  v.runs[2].torque_Nm = 0.01;  // a percentage of almost nothing
  v.curves = {{Estimator::A, {0.54, 0.54, 0.54}}};
  const method::selection::QualityErrorsResult q =
      method::selection::identify_quality_errors(v, nullptr);
  EXPECT_EQ(q.runs_left_out, 2U);
  EXPECT_TRUE(std::isnan(q.errors[0].percent[1]));
  EXPECT_TRUE(std::isnan(q.errors[0].percent[2]));
  EXPECT_NEAR(q.errors[0].rms_percent, 1.0, 1e-12);
}

TEST(QualityErrors, WithoutAnyReferenceItSaysWhatToRecord) {
  method::viscous::ViscousCurvesResult v;
  method::viscous::ConstantSpeedRun run;
  run.torque_Nm = 4.0;
  run.direction_difference_Nm = std::nan("");
  v.runs = {run};
  v.curves = {{Estimator::A, {0.54}}};
  const method::selection::QualityErrorsResult q =
      method::selection::identify_quality_errors(v, nullptr);
  EXPECT_EQ(q.stage.state, statistics::StageState::not_identifiable);
  EXPECT_NE(wording::words(q.stage.reason).find("both directions"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::quality_errors_test
