// Figures 15, 16, 17 and 22.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures/hand_made_calibration.h"
#include "figures/hysteresis_loops.h"
#include "figures/torque_choice.h"

namespace tribolog::figures::loop_figures_test {
namespace {

namespace known = test::known;
constexpr double micro = 1e6;
constexpr double milli = 1e3;
constexpr double scaling_error = 1e-9;  // display scaling only

const render::figure::PointLabel* point(const render::figure::Panel& panel,
                                        const std::string& text) {
  for (const render::figure::PointLabel& label : panel.point_labels) {
    if (label.text == text) return &label;
  }
  return nullptr;
}

class LoopFigures : public ::testing::Test {
 protected:
  joint::Dataset dataset_ = test::hand_made_dataset();
  calibration::Calibration calibration_ = test::hand_made_calibration(dataset_);
};

TEST_F(LoopFigures, PointsAToFStandOnTheCalibrationsNumbers) {
  const auto torque = torque_loop_figure(calibration_);
  const auto bristle = bristle_loop_figure(calibration_);
  const auto rate = bristle_rate_loop_figure(calibration_);
  ASSERT_TRUE(torque && bristle && rate);
  ASSERT_EQ(calibration_.hysteresis.points.size(), method::hysteresis::loop_points.size());
  for (const method::hysteresis::LoopPoint& expected : calibration_.hysteresis.points) {
    const std::string name = to_string(expected.name);
    SCOPED_TRACE(name);
    const struct {
      const ReportFigure& figure;
      double value;
    } views[] = {{*torque, expected.torque_Nm},
                 {*bristle, expected.z_rad * milli},
                 {*rate, expected.dz_rad_s * milli}};
    for (const auto& view : views) {
      ASSERT_EQ(view.figure.figure.panels.size(), 2U);
      const render::figure::PointLabel* over_angle = point(view.figure.figure.panels[0], name);
      const render::figure::PointLabel* over_time = point(view.figure.figure.panels[1], name);
      ASSERT_TRUE(over_angle != nullptr && over_time != nullptr);
      EXPECT_NEAR(over_angle->x, (expected.q_rad - known::centre_rad) * micro, 1e-6);
      EXPECT_NEAR(over_angle->y, view.value, scaling_error);
      EXPECT_NEAR(over_time->x, expected.t_s, scaling_error);
      EXPECT_NEAR(over_time->y, view.value, scaling_error);
    }
  }
}

TEST_F(LoopFigures, FirstStrokesRunFromTheStartPastTheLastReading) {
  const auto figure = torque_loop_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels.front();
  ASSERT_EQ(panel.series.size(), 3U);  // all samples, first strokes, mid-line
  const render::figure::Series& strokes = panel.series[1];
  EXPECT_EQ(strokes.x.size(), 251U);  // one and a quarter of 200 samples, both ends counted
  EXPECT_FALSE(strokes.direction_arrows_at.empty());
  EXPECT_EQ(panel.series[0].x.size(), calibration_.curves.loops[0].t_s.size());
}

TEST_F(LoopFigures, AxesSayMicroradiansAndMilliradians) {
  EXPECT_NE(torque_loop_figure(calibration_)->figure.panels[0].x.title.find("[µrad]"),
            std::string::npos);
  EXPECT_NE(bristle_loop_figure(calibration_)->figure.panels[0].y.title.find("[mrad]"),
            std::string::npos);
}

TEST_F(LoopFigures, FittedBristleIsCalledAModel) {
  calibration_.hysteresis.bristle_source = {"loop.bristle_fitted"};
  method::hysteresis::LuGreFit fit;
  calibration_.curves.loops[0].model_torque_Nm = calibration_.curves.loops[0].torque_Nm;
  calibration_.lugre = fit;
  for (const auto& figure : {torque_loop_figure(calibration_), bristle_loop_figure(calibration_),
                             bristle_rate_loop_figure(calibration_)}) {
    ASSERT_TRUE(figure);
    EXPECT_NE(figure->caption.find("LuGre model fitted"), std::string::npos) << figure->caption;
    const auto& series = figure->figure.panels.front().series;
    EXPECT_TRUE(std::any_of(series.begin(), series.end(), [](const render::figure::Series& one) {
      return one.label.find("LuGre") != std::string::npos;
    }));
  }
}

TEST_F(LoopFigures, CaptionHasTheReadings) {
  const auto figure = torque_loop_figure(calibration_);
  ASSERT_TRUE(figure);
  EXPECT_NE(figure->caption.find("4.0000 ± 0.0080 N·m"), std::string::npos) << figure->caption;
  EXPECT_NE(figure->caption.find("A 4.800"), std::string::npos) << figure->caption;
  EXPECT_NE(figure->alt.find("1.600 N·m"), std::string::npos) << figure->alt;
}

TEST_F(LoopFigures, ChoiceMarksThePapersPointAndItsShiftFromThePeak) {
  const auto figure = torque_choice_figure(calibration_);
  ASSERT_TRUE(figure);
  ASSERT_EQ(figure->figure.panels.size(), 2U);
  const method::hysteresis::LoopPoint& chosen = calibration_.hysteresis.points[3];
  ASSERT_EQ(chosen.name, method::hysteresis::Estimator::B);
  const render::figure::PointLabel* label =
      point(figure->figure.panels[0], "B, the paper's choice");
  ASSERT_NE(label, nullptr);
  EXPECT_NEAR(label->x, (chosen.q_rad - known::q_peak_rad) * micro, 1e-6);
  EXPECT_NEAR(label->y, chosen.torque_Nm, scaling_error);
  // Half a cycle after the start and 0.025 cycles on: -100 µrad sin(9°).
  EXPECT_TRUE(std::any_of(
      figure->figure.panels[0].point_labels.begin(), figure->figure.panels[0].point_labels.end(),
      [](const auto& one) { return one.text.find("= −15.6 µrad") != std::string::npos; }));
  // The peak is known to 500 µrad.
  EXPECT_NE(figure->caption.find("only known to ± 500 µrad"), std::string::npos) << figure->caption;
}

TEST_F(LoopFigures, CloseUpHoldsAllItsReadings) {
  const auto figure = torque_choice_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels[1];
  ASSERT_TRUE(panel.y.minimum && panel.y.maximum);
  EXPECT_EQ(panel.point_labels.size(), 4U);
  for (const render::figure::PointLabel& label : panel.point_labels) {
    EXPECT_GT(label.y, *panel.y.minimum) << label.text;
    EXPECT_LT(label.y, *panel.y.maximum) << label.text;
  }
}

TEST_F(LoopFigures, FurtherOscillationsAreMentioned) {
  EXPECT_EQ(torque_loop_figure(calibration_)->caption.find("oscillations"), std::string::npos);
  calibration_.curves.loops.push_back(calibration_.curves.loops.front());
  EXPECT_NE(torque_loop_figure(calibration_)->caption.find("first of 2 oscillations"),
            std::string::npos);
}

TEST_F(LoopFigures, ReadingsThatCoincideAreLabelledOnce) {
  calibration_.hysteresis.steady_points = calibration_.hysteresis.points;
  const auto figure = torque_choice_figure(calibration_);
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->figure.panels[1].point_labels.size(), 2U);
}

TEST_F(LoopFigures, PeakFarFromTheLoopIsNotDrawnOnIt) {
  calibration_.q_peak_rad = statistics::symmetric_estimate(known::q_peak_rad + 0.01, 0.02,
                                                           Statement::verbatim("by hand"));
  for (const auto& figure :
       {torque_loop_figure(calibration_), torque_choice_figure(calibration_)}) {
    ASSERT_TRUE(figure);
    EXPECT_TRUE(figure->figure.panels[0].reference_lines.empty());
    EXPECT_NE(figure->figure.panels[0].x.title.find("q_{0}"), std::string::npos);
  }
}

}  // namespace
}  // namespace tribolog::figures::loop_figures_test
