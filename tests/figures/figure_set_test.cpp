#include "figures/figure_set.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "figures/figure_csv.h"
#include "figures/hand_made_calibration.h"

namespace tribolog::figure_set_test {
namespace {

std::vector<int> numbers(const std::vector<figures::ReportFigure>& figures) {
  std::vector<int> all;
  for (const figures::ReportFigure& figure : figures)
    all.push_back(figure.paper_number.value_or(0));
  return all;
}

TEST(FigureSet, CompleteCalibrationGivesThePapersFigures) {
  const joint::Dataset dataset = test::hand_made_dataset();
  const auto figures = figures::figure_set(dataset, test::hand_made_calibration(dataset));
  EXPECT_EQ(numbers(figures), (std::vector<int>{11, 13, 14, 15, 16, 17, 0, 18, 19, 20, 21, 22}));
}

TEST(FigureSet, SweepAloneHasNoLoopFigures) {
  const joint::Dataset dataset = test::hand_made_dataset();
  const auto figures = figures::figure_set(dataset, test::sweep_only_calibration(dataset));
  EXPECT_EQ(numbers(figures), (std::vector<int>{11, 13, 0, 18, 19, 20, 21}));
}

TEST(FigureSet, LoopWithoutBristleHasNoBristleFigures) {
  const joint::Dataset dataset = test::hand_made_dataset();
  calibration::Calibration calibration = test::hand_made_calibration(dataset);
  calibration.hysteresis.bristle_source = {};
  calibration.hysteresis.points.clear();
  calibration.curves.loops.front().z_rad.clear();
  calibration.curves.loops.front().dz_rad_s.clear();
  calibration.selection.paper_rule.reset();
  EXPECT_EQ(numbers(figures::figure_set(dataset, calibration)),
            (std::vector<int>{11, 13, 14, 15, 0, 18, 19, 20, 21, 22}));
}

TEST(FigureSet, NoReferenceNoComparison) {
  const joint::Dataset dataset = test::hand_made_dataset();
  calibration::Calibration calibration = test::hand_made_calibration(dataset);
  calibration.quality = {};
  EXPECT_EQ(numbers(figures::figure_set(dataset, calibration)),
            (std::vector<int>{11, 13, 14, 15, 16, 17, 0, 18, 21, 22}));
}

TEST(FigureSet, AReportLeavesOutWhatAnotherFigureCombines) {
  const joint::Dataset dataset = test::hand_made_dataset();
  const auto all = figures::figure_set(dataset, test::hand_made_calibration(dataset));
  const auto shown = figures::for_a_report(all);
  // The hand-made one has no choice of a law: its selected curve stays.
  EXPECT_EQ(numbers(shown), (std::vector<int>{11, 13, 14, 15, 16, 17, 0, 21, 22}));
  for (const figures::ReportFigure& figure : shown) {
    EXPECT_EQ(figure.figure.title, "");
    EXPECT_NE(figure.title, "");
    EXPECT_EQ(figure.figure.width_px, figure.is_primary ? 1400 : 880) << figure.id;
  }
}

TEST(FigureSet, AFewArePrimary) {
  const joint::Dataset dataset = test::hand_made_dataset();
  std::vector<std::string> primary;
  for (const auto& one : figures::figure_set(dataset, test::hand_made_calibration(dataset))) {
    if (one.is_primary) primary.push_back(one.id);
  }
  EXPECT_EQ(primary, (std::vector<std::string>{"fig-13-rough-torque", "fig-14-precise-torque",
                                               "fig-15-hysteresis", "fig-friction-candidates"}));
}

// No text of any figure gives a current in newton metres.
TEST(FigureSet, SaysAmperesWhereTheTorqueConstantIsNotKnown) {
  const joint::Dataset dataset = test::hand_made_dataset();
  calibration::Calibration calibration = test::hand_made_calibration(dataset);
  calibration.manifest.torque_is_in_amperes = true;
  bool says_ampere = false;
  for (const figures::ReportFigure& one : figures::figure_set(dataset, calibration)) {
    constexpr std::size_t rows = 10;
    const std::string all =
        figures::figure_csv(one, rows) + one.title + one.caption + one.how_to_read + one.alt;
    EXPECT_EQ(all.find("N·m"), std::string::npos) << all;
    says_ampere = says_ampere || all.find("driving torque T [A]") != std::string::npos;
  }
  EXPECT_TRUE(says_ampere);
}

TEST(FigureSet, NothingGivesNothing) {
  EXPECT_TRUE(figures::figure_set(joint::Dataset{}, calibration::Calibration{}).empty());
}

TEST(FigureSet, EveryFigureIsCompleteInWords) {
  const std::set<std::string> stages{"cog_rough",        "cog_precise",        "hysteresis",
                                     "surrogate_masses", "viscous_curves",     "quality_errors",
                                     "selection",        "friction_parameters"};
  const std::string safe = "abcdefghijklmnopqrstuvwxyz0123456789-";
  const joint::Dataset dataset = test::hand_made_dataset();
  std::set<std::string> ids;
  for (const figures::ReportFigure& figure :
       figures::figure_set(dataset, test::hand_made_calibration(dataset))) {
    SCOPED_TRACE(figure.id);
    EXPECT_TRUE(ids.insert(figure.id).second);
    EXPECT_EQ(figure.id.find_first_not_of(safe), std::string::npos);
    EXPECT_EQ(figure.id, figure.figure.id);
    EXPECT_EQ(figure.title, figure.figure.title);
    EXPECT_FALSE(figure.title.empty());
    EXPECT_LE(figure.title.size(), 60U);
    EXPECT_EQ(stages.count(figure.stage), 1U) << figure.stage;
    for (const std::string& text : {figure.caption, figure.how_to_read, figure.alt}) {
      ASSERT_FALSE(text.empty());
      EXPECT_EQ(text.back(), '.') << text;
      EXPECT_EQ(text.find("_{"), std::string::npos) << text;
      EXPECT_EQ(text.find("unknown"), std::string::npos) << text;
      EXPECT_EQ(text.find("nan"), std::string::npos) << text;
      EXPECT_EQ(text.find(".."), std::string::npos) << text;
    }
  }
}

TEST(FigureSet, SameInputSameFigures) {
  const joint::Dataset dataset = test::hand_made_dataset();
  const calibration::Calibration calibration = test::hand_made_calibration(dataset);
  const auto first = figures::figure_set(dataset, calibration);
  const auto second = figures::figure_set(dataset, calibration);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].caption, second[i].caption);
    EXPECT_EQ(first[i].alt, second[i].alt);
    EXPECT_EQ(first[i].figure.panels.size(), second[i].figure.panels.size());
  }
}

}  // namespace
}  // namespace tribolog::figure_set_test
