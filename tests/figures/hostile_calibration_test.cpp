// Calibrations that no stage should make, and logs that are hardly logs: no crash, no wrong
// lengths.

#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures/figure_set.h"
#include "figures/hand_made_calibration.h"

namespace tribolog::hostile_calibration_test {
namespace {

using method::hysteresis::Estimator;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double huge = 1e300;

void expect_drawable(const std::vector<figures::ReportFigure>& figures) {
  for (const figures::ReportFigure& figure : figures) {
    SCOPED_TRACE(figure.id);
    EXPECT_FALSE(figure.figure.panels.empty());
    EXPECT_FALSE(figure.caption.empty());
    for (const render::figure::Panel& panel : figure.figure.panels) {
      EXPECT_FALSE(panel.series.empty());
      for (const render::figure::Series& series : panel.series) {
        EXPECT_EQ(series.x.size(), series.y.size());
      }
    }
  }
}

class HostileCalibration : public ::testing::Test {
 protected:
  void expect_figures_survive() const {
    expect_drawable(figures::figure_set(dataset_, calibration_));
  }

  joint::Dataset dataset_ = test::hand_made_dataset();
  calibration::Calibration calibration_ = test::hand_made_calibration(dataset_);
};

TEST_F(HostileCalibration, FoundButEmpty) {
  calibration::Calibration empty;
  empty.rough.found = empty.precise.found = empty.hysteresis.found = true;
  empty.selection.recommended = Estimator::midline;
  empty.selection.paper_rule = Estimator::B;
  empty.quality.reference = method::selection::CurveReference::analytic;
  expect_drawable(figures::figure_set(joint::Dataset{}, empty));
  expect_drawable(figures::figure_set(dataset_, empty));
}

TEST_F(HostileCalibration, OneSampleEverywhere) {
  for (joint::Recording& recording : dataset_.recordings) {
    recording.t_s.resize(1);
    recording.q_rad.resize(1);
    recording.torque_Nm.resize(1);
    recording.z_rad.clear();
  }
  for (method::gravity::SweepCurves* sweep :
       {&calibration_.curves.rough, &calibration_.curves.precise}) {
    sweep->used = {{true}};
    sweep->fit_q_rad.resize(1);
    sweep->fit_rising_Nm.resize(1);
    sweep->fit_falling_Nm.resize(1);
  }
  method::hysteresis::LoopTrace& trace = calibration_.curves.loops.front();
  for (auto* signal : {&trace.t_s, &trace.q_rad, &trace.torque_Nm, &trace.z_rad, &trace.dz_rad_s,
                       &trace.midline_q_rad, &trace.midline_Nm}) {
    signal->resize(1);
  }
  calibration_.viscous.runs.resize(1);
  expect_figures_survive();
}

TEST_F(HostileCalibration, RecordingsWithoutASample) {
  dataset_.recordings.assign(3, joint::Recording{});
  calibration_.curves.rough.used.clear();
  calibration_.curves.loops.front() = method::hysteresis::LoopTrace{};
  expect_figures_survive();
}

TEST_F(HostileCalibration, NumbersThatAreNone) {
  for (const double poison : {nan, infinity, -infinity, huge, -huge}) {
    SCOPED_TRACE(poison);
    calibration_ = test::hand_made_calibration(dataset_);
    const statistics::Estimate bad{poison, poison, poison, {}};
    for (method::gravity::CogSweepResult* sweep : {&calibration_.rough, &calibration_.precise}) {
      sweep->q_peak_rad = sweep->gravity_Nm = bad;
      sweep->argmax_rad = sweep->argmax_torque_Nm = sweep->argmax_low_rad = poison;
      sweep->argmax_high_rad = poison;
    }
    calibration_.q_peak_rad = bad;
    calibration_.hysteresis.midline_Nm = bad;
    calibration_.hysteresis.loop_height_Nm = poison;
    calibration_.hysteresis.oscillations.front() = {poison, poison, poison, poison, poison, poison};
    for (method::hysteresis::LoopPoint& point : calibration_.hysteresis.points) {
      point = {point.name, poison, poison, poison, poison, poison, poison, poison};
    }
    calibration_.curves.loops.front().midline_Nm.front() = poison;
    for (method::viscous::ConstantSpeedRun& run : calibration_.viscous.runs)
      run.torque_half_width_Nm = poison;
    calibration_.viscous.runs.front().speed_rad_s = poison;
    calibration_.viscous.curves.front().friction_Nm.front() = poison;
    calibration_.quality.reference_Nm.front() = poison;
    calibration_.quality.errors.front().percent.front() = poison;
    calibration_.model.law.level_Nm = poison;
    calibration_.model.law.slowest_rad_s = poison;
    calibration_.friction.waiboer->asperity_torque_Nm.value = poison;
    for (method::hysteresis::SurrogateMass& mass : calibration_.masses.masses) mass.mass_kg = bad;
    expect_figures_survive();
  }
}

TEST_F(HostileCalibration, SamplesThatAreNotNumbersLeaveGaps) {
  for (joint::Recording& recording : dataset_.recordings) {
    recording.torque_Nm[100] = nan;
    recording.q_rad[200] = nan;
  }
  calibration_.curves.loops.front().torque_Nm[10] = nan;
  expect_figures_survive();
}

TEST_F(HostileCalibration, VectorsOfDifferentLengths) {
  calibration_.curves.rough.used.front() = std::vector<bool>(10, true);
  calibration_.curves.rough.fit_rising_Nm.resize(3);
  calibration_.curves.precise.used.clear();
  calibration_.curves.loops.front().z_rad.resize(7);
  calibration_.curves.loops.front().torque_Nm.resize(20);
  calibration_.curves.loops.front().midline_Nm.push_back(1.0);
  calibration_.viscous.curves.front().friction_Nm.resize(1);
  calibration_.viscous.curves.back().friction_Nm.resize(50, 1.0);
  calibration_.quality.reference_Nm.resize(2);
  calibration_.quality.errors.front().percent.clear();
  expect_figures_survive();
}

TEST_F(HostileCalibration, NothingChosenAndEveryPointTheSame) {
  calibration_.selection.recommended.reset();
  calibration_.selection.paper_rule.reset();
  calibration_.quality.reference = method::selection::CurveReference::none;
  for (method::hysteresis::LoopPoint& point : calibration_.hysteresis.points) {
    point.name = Estimator::A;
  }
  expect_figures_survive();
}

TEST_F(HostileCalibration, AnEstimatorWithoutMassOrCurveIsRecommended) {
  calibration_.selection.recommended = Estimator::stated;
  calibration_.selection.paper_rule = Estimator::model;
  calibration_.viscous.curves.front().estimator = Estimator::fit;
  expect_figures_survive();
}

TEST_F(HostileCalibration, AllRunsAtStandstillOrOneDirection) {
  for (method::viscous::ConstantSpeedRun& run : calibration_.viscous.runs) run.speed_rad_s = 0.0;
  expect_figures_survive();
  for (method::viscous::ConstantSpeedRun& run : calibration_.viscous.runs) run.speed_rad_s = 5.0;
  expect_figures_survive();
}

}  // namespace
}  // namespace tribolog::hostile_calibration_test
