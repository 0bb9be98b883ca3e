// Figures 18 to 21.

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "figures/candidate_figures.h"
#include "figures/hand_made_calibration.h"
#include "figures/selected_curve.h"
#include "friction/static_laws.h"

namespace tribolog::figures::run_figures_test {
namespace {

bool has_label(const render::figure::Panel& panel, const std::string& part) {
  return std::any_of(panel.series.begin(), panel.series.end(),
                     [&](const render::figure::Series& series) {
                       return series.label.find(part) != std::string::npos;
                     });
}

bool has_label_beginning(const render::figure::Panel& panel, const std::string& beginning) {
  return std::any_of(
      panel.series.begin(), panel.series.end(),
      [&](const render::figure::Series& series) { return series.label.rfind(beginning, 0) == 0; });
}

class RunFigures : public ::testing::Test {
 protected:
  joint::Dataset dataset_ = test::hand_made_dataset();
  calibration::Calibration calibration_ = test::hand_made_calibration(dataset_);
};

TEST_F(RunFigures, EveryCandidateHasACurveOnBothSidesOfZero) {
  const auto figure = friction_curves_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels.front();
  // AB, CD, EF and the sweep lie within a line's width of the mid-line and are named with it.
  EXPECT_EQ(panel.series.size(), 2U * (1 + 6));
  EXPECT_TRUE(has_label(panel, "= sweep fit, AB, CD and EF"));
  for (const render::figure::Series& series : panel.series) {
    // A line never crosses standstill, where friction jumps.
    EXPECT_TRUE(series.x.back() < 0.0 || series.x.front() > 0.0);
  }
  EXPECT_TRUE(has_label(panel, "mid-line (81.7 kg)"));
  EXPECT_NE(figure->caption.find("8 runs (4 forward, 4 backward) from 1.00 to 300 rad/s"),
            std::string::npos)
      << figure->caption;
}

TEST_F(RunFigures, TheCombinedFigureHasTheChosenCurveStrongAndTheErrorsBelowUnderTheSameNames) {
  const auto figure = friction_candidates_figure(calibration_);
  ASSERT_TRUE(figure);
  EXPECT_TRUE(figure->is_primary);
  EXPECT_FALSE(figure->paper_number);
  ASSERT_EQ(figure->figure.panels.size(), 2U);
  const render::figure::Panel& curves = figure->figure.panels[0];
  const render::figure::Panel& errors = figure->figure.panels[1];
  EXPECT_TRUE(has_label_beginning(curves, "reference"));
  EXPECT_FALSE(has_label_beginning(errors, "reference"));
  EXPECT_TRUE(curves.labels_at_ends && errors.labels_at_ends);
  for (const render::figure::Series& one : errors.series) {
    EXPECT_TRUE(one.label.empty() || has_label_beginning(curves, one.label)) << one.label;
  }
  EXPECT_EQ(curves.x.linear_within, errors.x.linear_within);
  EXPECT_GT(curves.x.linear_within, 0);
  EXPECT_NE(errors.y.title.find("[%]"), std::string::npos);
  for (const render::figure::Panel& panel : figure->figure.panels) {
    double strongest_other = 0;
    double chosen = 0;
    std::string label;
    for (const render::figure::Series& series : panel.series) {
      if (!series.label.empty()) label = series.label;
      if (label.starts_with("reference")) continue;
      double& width = label.starts_with("mid-line") ? chosen : strongest_other;
      width = std::max(width, series.width_px);
    }
    EXPECT_GT(chosen, 2 * strongest_other);
  }
  const auto paper = quality_error_figure(calibration_);
  ASSERT_TRUE(paper);
  EXPECT_FALSE(paper->is_primary);
}

TEST_F(RunFigures, TheCombinedFigureHasTheCurvesAloneWithoutAReference) {
  calibration_.quality = {};
  const auto figure = friction_candidates_figure(calibration_);
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->figure.panels.size(), 1U);
  EXPECT_EQ(figure->stage, "viscous_curves");
  calibration_.viscous.runs.clear();
  EXPECT_FALSE(friction_candidates_figure(calibration_));
}

TEST_F(RunFigures, CloseUpLeavesOutWhatIsFarAndSaysSo) {
  for (const auto& figure :
       {friction_against_reference_figure(calibration_), quality_error_figure(calibration_)}) {
    ASSERT_TRUE(figure);
    ASSERT_EQ(figure->figure.panels.size(), 2U);
    const render::figure::Panel& near = figure->figure.panels[1];
    EXPECT_NE(near.title.find("outside"), std::string::npos) << near.title;
    EXPECT_FALSE(has_label_beginning(near, "D ("));
    EXPECT_TRUE(has_label_beginning(near, "B ("));
    EXPECT_TRUE(has_label(near, "mid-line"));
    ASSERT_TRUE(near.y.minimum && near.y.maximum);
    EXPECT_DOUBLE_EQ(*near.y.minimum, -*near.y.maximum);
  }
}

TEST_F(RunFigures, CloseUpDrawsNoSeriesOutsideItsAxes) {
  // A is far off forward only: its other side stays.
  const auto& runs = calibration_.viscous.runs;
  for (method::selection::QualityError& error : calibration_.quality.errors) {
    if (error.estimator != method::hysteresis::Estimator::A) continue;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      error.percent[i] = runs[i].speed_rad_s > 0.0 ? 40.0 : 0.1;
    }
  }
  const auto figure = quality_error_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& near = figure->figure.panels.at(1);
  for (const render::figure::Series& series : near.series) {
    EXPECT_TRUE(std::any_of(series.y.begin(), series.y.end(), [&](double y) {
      return y >= *near.y.minimum && y <= *near.y.maximum;
    })) << series.label;
  }
  EXPECT_TRUE(has_label_beginning(near, "A ("));
  EXPECT_NE(near.title.find("A (forward)"), std::string::npos) << near.title;
}

TEST_F(RunFigures, ErrorsAreDrawnWithTheIntervalOfTheirReference) {
  EXPECT_TRUE(quality_error_figure(calibration_)->figure.panels.front().error_bars.empty());
  method::selection::QualityErrorsResult& quality = calibration_.quality;
  const auto& runs = calibration_.viscous.runs;
  quality.reference_half_width_Nm.assign(runs.size(), 0.02);
  quality.reference_rms_percent = 0.5;
  quality.errors.front().percent.back() = NAN;  // a run without a reference
  const auto figure = quality_error_figure(calibration_);
  for (const render::figure::Panel& panel : figure->figure.panels) {
    ASSERT_EQ(panel.error_bars.size(), runs.size() - 1);
    for (std::size_t i = 0; i < panel.error_bars.size(); ++i) {
      EXPECT_EQ(panel.error_bars[i].x, runs[i].speed_rad_s);
      EXPECT_EQ(panel.error_bars[i].low, -panel.error_bars[i].high);
      // Half a per cent of 4 N·m is 0.02 N·m; friction adds to gravity or takes from it.
      EXPECT_NEAR(panel.error_bars[i].high, 0.5, 0.2);
    }
  }
  EXPECT_NE(figure->caption.find("95 % interval of the reference"), std::string::npos)
      << figure->caption;
}

TEST_F(RunFigures, DifferenceToTheReferenceIsTheErrorOfGravity) {
  const auto figure = friction_against_reference_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& near = figure->figure.panels[1];
  EXPECT_NE(near.y.title.find("[mN·m]"), std::string::npos) << near.y.title;
  for (const render::figure::Series& series : near.series) {
    if (series.label.find("mid-line") == std::string::npos) continue;
    for (const double difference : series.y) EXPECT_NEAR(difference, -5.0, 1e-6);
  }
  EXPECT_NE(figure->caption.find("5.0 mN·m"), std::string::npos) << figure->caption;
}

TEST_F(RunFigures, AxisDoesNotEnlargeTheRoundingOfAPerfectCandidate) {
  constexpr double rounding_Nm = 1e-15;
  for (method::viscous::ViscousCurve& curve : calibration_.viscous.curves) {
    curve.friction_Nm = calibration_.quality.reference_Nm;
    curve.friction_Nm.front() += rounding_Nm;
  }
  const auto figure = friction_against_reference_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& near = figure->figure.panels[1];
  ASSERT_TRUE(near.y.maximum);
  EXPECT_GT(*near.y.maximum, 0.5);
  EXPECT_NE(near.y.title.find("[µN·m]"), std::string::npos) << near.y.title;
  EXPECT_NE(figure->caption.find("below 1 µN·m"), std::string::npos) << figure->caption;
}

TEST_F(RunFigures, ErrorCaptionNamesBothSelections) {
  const auto figure = quality_error_figure(calibration_);
  ASSERT_TRUE(figure);
  EXPECT_NE(figure->caption.find("B "), std::string::npos);
  EXPECT_NE(figure->caption.find("mid-line "), std::string::npos);
  EXPECT_NE(figure->caption.find("%"), std::string::npos);
}

TEST_F(RunFigures, AnalyticReferenceIsDrawnAsACurve) {
  calibration_.quality.reference = method::selection::CurveReference::analytic;
  calibration_.manifest.reference = std::make_shared<friction::WaiboerFriction>(
      friction::WaiboerFriction::Parameters{0.5, 5.0, 0.7, 0.1, 0.5, 1e6});
  const auto figure = friction_against_reference_figure(calibration_);
  ASSERT_TRUE(figure);
  const auto& series = figure->figure.panels[0].series;
  const auto reference = std::find_if(series.begin(), series.end(), [](const auto& one) {
    return one.label == "reference: analytic curve";
  });
  ASSERT_NE(reference, series.end());
  EXPECT_GT(reference->x.size(), calibration_.viscous.runs.size());
  EXPECT_EQ(reference->marker, render::figure::Marker::none);
}

TEST_F(RunFigures, SelectedCurveFoldsTheDirectionsOntoEachOther) {
  const auto figure = selected_curve_figure(calibration_);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels.front();
  EXPECT_TRUE(panel.x.logarithmic);
  EXPECT_TRUE(has_label(panel, "mid-line (81.7 kg), forward"));
  EXPECT_TRUE(has_label(panel, "mid-line (81.7 kg), backward"));
  EXPECT_TRUE(has_label(panel, "model: Coulomb and viscous"));
  EXPECT_TRUE(has_label(panel, "Waiboer's law, fitted"));
  for (const render::figure::Series& series : panel.series) {
    for (const double speed : series.x) EXPECT_GT(speed, 0.0) << series.label;
  }
  EXPECT_EQ(panel.error_bars.size(), calibration_.viscous.runs.size());
  EXPECT_NE(figure->caption.find("3.1 mN·m"), std::string::npos) << figure->caption;
  ASSERT_EQ(figure->figure.panels.size(), 2U);
  const render::figure::Panel& left = figure->figure.panels.back();
  EXPECT_EQ(left.series.size(), 2U);
  const method::model::ModelLaw& law = calibration_.model.law;
  const auto& forward = left.series.front();
  const auto& points = panel.series;
  const auto above = std::find_if(points.begin(), points.end(), [](const auto& one) {
    return one.label == "mid-line (81.7 kg), forward";
  });
  ASSERT_NE(above, points.end());
  const double in_Nm = left.y.title.find("mN") != std::string::npos ? 1e-3 : 1;
  EXPECT_NEAR(in_Nm * forward.y.front(), above->y.front() - law.friction_Nm(above->x.front()),
              1e-9);
}

TEST_F(RunFigures, AngleBinsOfASweepStayMarkers) {
  const calibration::Calibration sweep = test::sweep_only_calibration(dataset_);
  const auto figure = friction_curves_figure(sweep);
  ASSERT_TRUE(figure);
  for (const render::figure::Series& series : figure->figure.panels.front().series) {
    EXPECT_EQ(series.style, render::figure::LineStyle::none);
    EXPECT_NE(series.marker, render::figure::Marker::none);
  }
}

}  // namespace
}  // namespace tribolog::figures::run_figures_test
