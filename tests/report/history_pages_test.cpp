// The pages of `archive diff` and `archive trend`.

#include <gtest/gtest.h>

#include "figures/comparison_figures.h"
#include "figures/trend_figures.h"
#include "history/simulated_history.h"
#include "report/comparison_page.h"
#include "report/document_checks.h"
#include "report/run_python.h"
#include "report/sample_calibration.h"
#include "report/trend_page.h"

namespace tribolog::test::history_pages_test {
namespace {

/// Coulomb torque 8 % more from the 15th calibration on; every text as given.
std::vector<calibration::Measured> history_with(const std::string& text) {
  HistoryShape shape;
  shape.calibrations = 24;
  shape.noise = {0, 0.0022};  // what the intervals say, and nothing beside
  for (std::size_t k = 0; k < shape.calibrations; ++k) {
    shape.temperature_C.push_back(20 + static_cast<double>(k % 7));
  }
  auto all = simulated_history(
      3,
      [](const std::string& name, std::size_t k) {
        return name == "coulomb_torque" && k >= 14 ? 1.08 : 1.0;
      },
      shape);
  for (calibration::Measured& m : all) {
    calibration::Facts& f = m.entry.facts;
    f.of = {text, text, text};
    f.operator_name = f.note = f.payload = f.tool_version = text;
    for (calibration::Quantity& q : m.quantities) q.words = text + q.name;
    m.quantities.back().unit = text;
  }
  return all;
}

calibration::Provenance provenance_with(const std::string& text) {
  calibration::Provenance p = sample_provenance();
  p.tool_version = p.command_line = text;
  return p;
}

std::string trend_page_with(const std::string& text) {
  const auto trends = history::joint_trends(history_with(text), {});
  const auto figures = figures::trend_figures(trends);
  return report::trend_page(trends, provenance_with(text), figures, sample_pictures(figures));
}

std::string diff_page_with(const std::string& text) {
  const auto all = history_with(text);
  const auto c = history::compare(all[0], all[20], {10, 2}, false);
  const auto figures = figures::comparison_figures(c, simple_curves(0), simple_curves(0.1));
  return report::comparison_page(c, provenance_with(text), text, figures, sample_pictures(figures));
}

TEST(HistoryPages, AreWholeDocuments) {
  if (!has_python_module("html.parser")) GTEST_SKIP() << "python3 is not installed";
  EXPECT_TRUE(run_python(checks, trend_page_with("x ")));
  EXPECT_TRUE(run_python(checks, diff_page_with("x ")));
}

TEST(HistoryPages, TextOfStrangersStaysText) {
  if (!has_python_module("html.parser")) GTEST_SKIP() << "python3 is not installed";
  for (std::string (*const page)(const std::string&) : {trend_page_with, diff_page_with}) {
    const std::string attacked = page(hostile);
    const auto plain_shape = run_python(skeleton, page("x"));
    const auto attacked_shape = run_python(skeleton, attacked);
    ASSERT_TRUE(plain_shape && attacked_shape);
    EXPECT_EQ(*plain_shape, *attacked_shape);
    EXPECT_EQ(occurrences(attacked, "<script"), 1U);
    const std::string body = attacked.substr(0, attacked.find("<script type"));
    EXPECT_EQ(body.find("\u202E"), std::string::npos);
    EXPECT_EQ(body.find('\x1b'), std::string::npos);
    EXPECT_EQ(body.find('\xff'), std::string::npos);
  }
}

TEST(HistoryPages, TellTheChange) {
  const std::string trend = trend_page_with("x ");
  EXPECT_NE(trend.find("coulomb_torque has risen by"), std::string::npos)
      << trend.substr(trend.find("<section id=\"verdict\""), 2500);
  EXPECT_NE(trend.find("visible from " + utc_of_day(14 * 14).substr(0, 10)), std::string::npos);
  const std::string diff = diff_page_with("x ");
  EXPECT_NE(diff.find(">CHANGED<"), std::string::npos);
  EXPECT_NE(diff.find("1 of 9 comparable quantities changed."), std::string::npos)
      << diff.substr(diff.find("<section id=\"verdict\""), 2500);
}

TEST(HistoryPages, TablesHaveTheCellsOfTheirColumns) {
  const auto all = history_with("x ");
  const auto c = history::compare(all[0], all[20], {10, 2}, false);
  const report::Table changes = report::compared_quantities_table(c);
  for (const report::Row& row : changes.rows) ASSERT_EQ(row.cells.size(), changes.columns.size());
  EXPECT_EQ(changes.rows[0].cells.front(), "x coulomb_torque [N·m]");
  EXPECT_EQ(changes.rows[0].cells.back(), "changed");
  EXPECT_EQ(changes.rows[6].cells.back(), "no change seen");
  const report::Table conditions = report::compared_conditions_table(c);
  for (const report::Row& row : conditions.rows) EXPECT_EQ(row.cells.size(), 3U);
  const report::Table trend = report::trend_table(history::joint_trends(all, {}).front(), "t");
  for (const report::Row& row : trend.rows) EXPECT_EQ(row.cells.size(), trend.columns.size());
}

TEST(HistoryPages, OneCalibrationAndNoFigureMakeAPageToo) {
  auto all = history_with("x ");
  all.resize(1);
  const auto trends = history::joint_trends(all, {});
  const std::string page =
      report::trend_page(trends, sample_provenance(), figures::trend_figures(trends), {});
  EXPECT_NE(page.find("TOO FEW YET"), std::string::npos);
  EXPECT_NE(page.find("This figure is missing"), std::string::npos);
}

TEST(HistoryFigures, ShowEveryCalibrationOnce) {
  auto all = history_with("x ");
  all[3].quantities[0].verdict = calibration::Verdict::doubtful;
  const auto trends = history::joint_trends(all, {});
  const auto figures = figures::trend_figures(trends);
  ASSERT_EQ(figures.size(), 9U);
  const render::figure::Panel& values = figures.front().figure.panels.front();
  EXPECT_TRUE(values.x.dates);
  EXPECT_EQ(values.error_bars.size(), 23U);
  std::size_t left_out = 0, shown = 0;
  for (const render::figure::Series& s : values.series) {
    if (s.label == "left out") left_out += s.x.size();
    if (s.label.find("the first") == 0 || s.label.find("calibration") == 0) shown += s.x.size();
  }
  EXPECT_EQ(left_out, 1U);
  EXPECT_EQ(shown, 23U);
  ASSERT_EQ(values.reference_lines.size(), 2U) << "visible from, and the alarm";
  // 2024-01-01 is day 19723; the step is measured on 2024-08-01 by the made-up calendar.
  EXPECT_NEAR(values.reference_lines.front().at, 19723 + 213 + 10 / 24.0, 1e-9);
  EXPECT_EQ(figures.front().figure.panels.size(), 2U);
}

TEST(HistoryFigures, AChangeThatStandsComesFirst) {
  auto all = history_with("x ");
  for (calibration::Measured& m : all) std::swap(m.quantities[0], m.quantities[6]);
  const auto figures = figures::trend_figures(history::joint_trends(all, {}));
  EXPECT_EQ(figures.front().id, "trend-1-7");
  EXPECT_EQ(figures[1].id, "trend-1-1");
}

TEST(HistoryFigures, OfTwoCalibrationsNeedBoth) {
  const auto all = history_with("x ");
  const auto c = history::compare(all[0], all[1], {}, false);
  EXPECT_EQ(figures::comparison_figures(c, simple_curves(0), simple_curves(0)).size(), 2U);
  EXPECT_TRUE(figures::comparison_figures(c, simple_curves(0), {}).empty());
  calibration::RecordedCurves old = simple_curves(0);
  old.loops.clear();
  EXPECT_EQ(figures::comparison_figures(c, old, simple_curves(0)).size(), 1U);
}

}  // namespace
}  // namespace tribolog::test::history_pages_test
