// Figures 11, 13 and 14.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures/hand_made_calibration.h"
#include "figures/sweep_motion.h"
#include "figures/sweep_torque.h"

namespace tribolog::figures::sweep_figures_test {
namespace {

namespace known = test::known;
constexpr double degree = 180.0 / 3.14159265358979323846;
// Display scaling only: a few roundings of a double.
constexpr double scaling_error = 1e-9;

std::size_t drawable(const render::figure::Series& series) {
  return static_cast<std::size_t>(
      std::count_if(series.x.begin(), series.x.end(), [](double x) { return std::isfinite(x); }));
}

class SweepFigures : public ::testing::Test {
 protected:
  joint::Dataset dataset_ = test::hand_made_dataset();
  calibration::Calibration calibration_ = test::hand_made_calibration(dataset_);
};

TEST_F(SweepFigures, MotionShowsAllSamplesAndColoursThoseUsed) {
  const auto figure = sweep_motion_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  ASSERT_EQ(figure->figure.panels.size(), 3U);
  EXPECT_TRUE(figure->figure.panels_share_x);
  for (const render::figure::Panel& panel : figure->figure.panels) {
    ASSERT_EQ(panel.series.size(), 3U);  // one stroke up, one down
    EXPECT_EQ(drawable(panel.series[0]), dataset_.recordings[0].size());
    EXPECT_EQ(drawable(panel.series[1]) + drawable(panel.series[2]), 780U);
  }
  EXPECT_NE(figure->caption.find("780 of 890"), std::string::npos) << figure->caption;
}

TEST_F(SweepFigures, StrokesAreSeparateLinesUnlessTheMaskFlickers) {
  const auto lines = [&] {
    return sweep_motion_figure(dataset_, calibration_)->figure.panels[0].series.size();
  };
  for (const std::size_t i : {100U, 200U, 300U}) calibration_.curves.rough.used[0][i] = false;
  EXPECT_EQ(lines(), 3U + 3U);
  for (std::size_t i = 0; i < 890; i += 3) calibration_.curves.rough.used[0][i] = false;
  EXPECT_EQ(lines(), 3U);
}

TEST_F(SweepFigures, MotorSpeedIsTheGearRatioTimesTheSlope) {
  const auto figure = sweep_motion_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Series& rising = figure->figure.panels[1].series[1];
  // 2.4 rad in 4 s at the joint.
  for (const double speed : rising.y) {
    if (std::isnan(speed)) continue;
    EXPECT_NEAR(speed, 60.0, 0.5);
  }
}

TEST_F(SweepFigures, RecordingsFollowEachOtherInTime) {
  dataset_.recordings[1].role = joint::Role::rough_sweep;
  calibration_.curves.rough.used.push_back(calibration_.curves.rough.used.front());
  const auto figure = sweep_motion_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  double before = -1.0;
  for (const double t : figure->figure.panels[0].series[0].x) {
    if (std::isnan(t)) continue;
    EXPECT_GE(t, before);
    before = t;
  }
}

TEST_F(SweepFigures, RoughTorqueMarksPeakAndArgmax) {
  const auto figure = rough_torque_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  ASSERT_EQ(figure->figure.panels.size(), 1U);
  const render::figure::Panel& panel = figure->figure.panels.front();
  ASSERT_EQ(panel.point_labels.size(), 1U);
  EXPECT_NEAR(panel.point_labels[0].x, calibration_.rough.argmax_rad * degree, scaling_error);
  EXPECT_NEAR(panel.point_labels[0].y, calibration_.rough.argmax_torque_Nm, scaling_error);
  ASSERT_EQ(panel.reference_lines.size(), 1U);
  EXPECT_NEAR(panel.reference_lines[0].at, known::q_peak_rad * degree, scaling_error);
  EXPECT_NE(figure->caption.find("−22.92° ± 0.17°"), std::string::npos) << figure->caption;
  EXPECT_NE(figure->caption.find("4.000 ± 0.012 N·m"), std::string::npos) << figure->caption;
  EXPECT_NE(figure->alt.find("−22.92°"), std::string::npos) << figure->alt;
}

TEST_F(SweepFigures, PreciseTorqueGivesEachDirectionItsPanelAndTheArgmaxToTheRisingOne) {
  const auto figure = precise_torque_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  ASSERT_EQ(figure->figure.panels.size(), 2U);
  EXPECT_EQ(figure->figure.panels[0].point_labels.size(), 1U);
  EXPECT_EQ(figure->figure.panels[1].point_labels.size(), 0U);
  // Torque bends by 0.8 mN·m on 4.5 N·m: the level is taken off.
  EXPECT_NE(figure->figure.panels[0].y.title.find("[mN·m]"), std::string::npos)
      << figure->figure.panels[0].y.title;
}

TEST_F(SweepFigures, ManySamplesOfThePreciseSweepAreMeansWithTheirSpread) {
  joint::Recording& recording = dataset_.recordings[1];
  const joint::Recording once = recording;
  std::vector<bool>& used = calibration_.curves.precise.used[0];
  const std::vector<bool> used_once = used;
  recording.t_s.clear();
  recording.q_rad.clear();
  recording.torque_Nm.clear();
  used.clear();
  // Quantised: each angle comes with 5 mN·m more and with 5 mN·m less.
  for (std::size_t i = 0; i < once.t_s.size(); ++i) {
    for (const double off : {-5e-3, 5e-3}) {
      recording.t_s.push_back(once.t_s[i] + (off > 0 ? 0.5 : 0) * (once.t_s[1] - once.t_s[0]));
      recording.q_rad.push_back(once.q_rad[i]);
      recording.torque_Nm.push_back(once.torque_Nm[i] + off);
      used.push_back(used_once[i]);
    }
  }
  const auto figure = precise_torque_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels.front();
  EXPECT_LE(panel.series.front().x.size(), 40U);
  ASSERT_EQ(panel.error_bars.size(), panel.series.front().x.size());
  ASSERT_GT(panel.error_bars.size(), 30U);
  for (const render::figure::ErrorBar& bar : panel.error_bars) {
    EXPECT_NEAR(bar.high - bar.low, 0.010, 0.0005);
  }
}

TEST_F(SweepFigures, OneDirectionNeedsOnePanel) {
  calibration_.curves.precise.fit_falling_Nm.clear();
  for (std::size_t i = 430; i < calibration_.curves.precise.used[0].size(); ++i) {
    calibration_.curves.precise.used[0][i] = false;
  }
  const auto figure = precise_torque_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->figure.panels.size(), 1U);
}

TEST_F(SweepFigures, ArgmaxAtTheEndIsSaid) {
  calibration_.rough.argmax_at_end = true;
  const auto figure = rough_torque_figure(dataset_, calibration_);
  ASSERT_TRUE(figure);
  EXPECT_NE(figure->caption.find("no peak was crossed"), std::string::npos);
}

TEST_F(SweepFigures, JointWithoutGearHasNoMotorSide) {
  dataset_.manifest.drive = joint::Drive(1.0, joint::EffortKind::joint_torque, joint::Side::joint);
  const auto motion = sweep_motion_figure(dataset_, calibration_);
  const auto torque = rough_torque_figure(dataset_, calibration_);
  ASSERT_TRUE(motion && torque);
  EXPECT_NE(motion->figure.panels[1].y.title.find("joint speed q"), std::string::npos);
  EXPECT_EQ(motion->caption.find("motor"), std::string::npos) << motion->caption;
  EXPECT_NE(torque->caption.find("at the joint"), std::string::npos) << torque->caption;
}

}  // namespace
}  // namespace tribolog::figures::sweep_figures_test
