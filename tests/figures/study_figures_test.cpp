// Figures of the Monte-Carlo study and of the known-truth check: what they show, by hand-made
// numbers.

#include "figures/experiments/study_figures.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "figures/cross_check_figures.h"
#include "wording/labels.h"

namespace tribolog::study_figures_test {
namespace {

using calibration::ReadingName;

study::StudiedReading reading(ReadingName name, truth::ReadingKind quantity, double truth,
                              double bias) {
  study::ErrorStatistics e;
  e.runs = e.found = 10;
  e.truth = truth;
  e.bias = bias;
  e.scatter = 0.01 * truth;
  e.coverage = {0.9, 0.6, 0.98};
  return {name, quantity, e};
}

/// Two levels; the second has no mid-line.
study::StudyResult two_levels() {
  study::StudyResult study;
  study.options.runs = 10;
  study::StudyFactor factor{"encoder", false, {}};
  factor.levels.push_back(
      {13, Statement{"study_level.counts", {{"counts", 8192}}}, true, "one", {}});
  factor.levels.push_back(
      {17, Statement{"study_level.counts", {{"counts", 131072}}}, false, "two", {}});
  study.factors.push_back(factor);
  study.cases = {{"one",
                  {reading(ReadingName::B, truth::ReadingKind::gravity, 4, -0.02),
                   reading(ReadingName::midline, truth::ReadingKind::gravity, 4, 0.004),
                   reading(ReadingName::q_peak, truth::ReadingKind::peak_angle, -0.4, 1e-5)}},
                 {"two", {reading(ReadingName::B, truth::ReadingKind::gravity, 4, -0.04)}}};
  return study;
}

TEST(StudyFigures, ShowBiasInPercentOfTheTruth) {
  const std::vector<figures::ReportFigure> figures =
      figures::experiments::study_figures(two_levels());
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].id, "study-gravity-encoder");
  EXPECT_EQ(figures[0].stage, "encoder");
  const render::figure::Panel& points = figures[0].figure.panels[0];
  ASSERT_EQ(points.series.size(), 2U);
  EXPECT_EQ(points.series[0].label, "point B");
  EXPECT_EQ(points.series[0].x, (std::vector<double>{13, 17}));
  EXPECT_NEAR(points.series[0].y[0], -0.5, 1e-12);
  EXPECT_NEAR(points.series[0].y[1], -1, 1e-12);
  // Not found at the second level: no point there.
  EXPECT_EQ(points.series[1].x, std::vector<double>{13});
  EXPECT_NE(figures[0].caption.find("point B −1.000 to −0.500 %"), std::string::npos)
      << figures[0].caption;
}

TEST(StudyFigures, ShowTheAngleInThousandthsOfADegree) {
  const std::vector<figures::ReportFigure> figures =
      figures::experiments::study_figures(two_levels());
  const render::figure::Panel& angle = figures[1].figure.panels[0];
  ASSERT_EQ(angle.series.size(), 1U);
  EXPECT_NEAR(angle.series[0].y[0], 0.573, 0.001);
}

TEST(StudyFigures, CoverageOfRunsThatAreAllAlikeIsNotShown) {
  study::StudyResult study = two_levels();
  for (study::StudiedCase& one : study.cases) {
    for (study::StudiedReading& r : one.readings) r.errors.scatter = 0;
  }
  const std::vector<figures::ReportFigure> figures = figures::experiments::study_figures(study);
  for (const render::figure::Panel& panel : figures[0].figure.panels) {
    EXPECT_EQ(panel.title.find("coverage"), std::string::npos);
  }
}

TEST(TruthCheckFigure, MarksWhatIsHeldAndWhatIsNot) {
  calibration::Calibration c;
  EXPECT_FALSE(figures::truth_check_figure(c));
  c.truth_check.runs = 3;
  c.truth_check.quantities = {{ReadingName::midline, "N·m", 4, 4, 0, 1, 3, 2, {-0.5, 0.5, 2}, true},
                              {ReadingName::fit,
                               "N·m",
                               4,
                               4,
                               0,
                               1,
                               2,
                               0,
                               {-40, std::numeric_limits<double>::infinity()},
                               false}};
  const auto figure = figures::truth_check_figure(c);
  ASSERT_TRUE(figure);
  const render::figure::Panel& panel = figure->figure.panels[0];
  ASSERT_EQ(panel.series.size(), 2U);
  EXPECT_EQ(panel.series[0].x, (std::vector<double>{-0.5, 0.5}));
  // The first row is the upper one; far points stand at the edge.
  EXPECT_EQ(panel.series[1].x, (std::vector<double>{2, -5}));
  EXPECT_GT(panel.series[1].y[0], panel.series[1].y[1]);
  ASSERT_EQ(panel.y.names.size(), 2U);
  EXPECT_EQ(panel.y.names[0].text, "mid-line");
  EXPECT_EQ(panel.y.names[0].at, 2);
  EXPECT_NE(figure->caption.find("2 of 5"), std::string::npos) << figure->caption;
}

TEST(ReadingLabel, MarksSubscriptsUp) {
  EXPECT_EQ(wording::reading_label("static_torque"), "break-away torque T_{s}");
  EXPECT_EQ(wording::reading_label("q_peak"), "gravity peak q_{peak}");
  EXPECT_EQ(wording::reading_label("midline"), "mid-line");
}

}  // namespace
}  // namespace tribolog::study_figures_test
