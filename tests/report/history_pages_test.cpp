// The pages of `archive diff` and `archive trend`.

#include <gtest/gtest.h>

#include "calibration/json_values.h"
#include "figures/timeline/comparison_figures.h"
#include "figures/timeline/trend_figures.h"
#include "history/simulated_history.h"
#include "report/document_checks.h"
#include "report/run_python.h"
#include "report/sample_calibration.h"
#include "report/timeline/comparison_page.h"
#include "report/timeline/trend_page.h"
#include "report/viewer/review_json.h"

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
  const auto figures = figures::timeline::trend_figures(trends);
  return report::timeline::trend_page(trends, provenance_with(text), figures,
                                      sample_pictures(figures));
}

std::string diff_page_with(const std::string& text) {
  const auto all = history_with(text);
  const auto c = history::compare(all[0], all[20], {10, 2}, false);
  const auto figures =
      figures::timeline::comparison_figures(c, simple_curves(0), simple_curves(0.1));
  return report::timeline::comparison_page(c, simple_curves(0), simple_curves(0.1),
                                           provenance_with(text), text, figures,
                                           sample_pictures(figures));
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
    // Of two calibrations with loops there is the viewer too: its data and its script.
    EXPECT_EQ(occurrences(attacked, "<script"), page == trend_page_with ? 1U : 3U);
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

TEST(HistoryPages, TheOutcomeIsOneSentence) {
  const auto all = history_with("x ");
  const auto c = history::compare(all[0], all[20], {10, 2}, false);
  const std::string sentence = report::timeline::comparison_sentence(c);
  EXPECT_EQ(sentence.find("x coulomb_torque rose by 0."), 0U) << sentence;
  EXPECT_NE(sentence.find("%), beyond chance; 1 of 9"), std::string::npos) << sentence;
  const auto back = history::compare(all[20], all[0], {10, 2}, false);
  EXPECT_NE(report::timeline::comparison_sentence(back).find(" fell by 0."), std::string::npos);
  const auto same = history::compare(all[0], all[2], {10, 2}, false);
  EXPECT_EQ(same.largest_change(), nullptr);
  EXPECT_EQ(report::timeline::comparison_sentence(same),
            "No change seen in 9 comparable quantities.");

  // The trend's first sentence is the change, and it does not stand below again.
  const std::string trend = trend_page_with("x ");
  const std::size_t at = trend.find("<p class=\"sentence\">");
  const std::string first = trend.substr(at, trend.find("</p>", at) - at);
  EXPECT_NE(first.find("coulomb_torque has risen by"), std::string::npos) << first;
  EXPECT_NE(first.find("No change is visible in 8 other quantities."), std::string::npos) << first;
  EXPECT_EQ(occurrences(trend, "coulomb_torque has risen by"), 1U);
}

TEST(HistoryPages, TheLargestChangeIsWhatItsIntervalLeaves) {
  history::Comparison c;
  const auto add = [&](const char* name, double percent, double half, history::ChangeWord word) {
    history::ComparedQuantity q;
    q.name = q.words = name;
    q.word = word;
    q.change = history::Change{statistics::symmetric_estimate(percent / 100, half / 100),
                               statistics::symmetric_estimate(percent, half), 0};
    c.quantities.push_back(q);
  };
  add("sure", -8, 1, history::ChangeWord::changed);
  add("vague", 20, 19, history::ChangeWord::changed);
  add("not changed", 90, 95, history::ChangeWord::no_change_seen);
  add("angle", 50, 1, history::ChangeWord::changed);
  c.quantities.back().change->percent.reset();
  ASSERT_NE(c.largest_change(), nullptr);
  EXPECT_EQ(c.largest_change()->name, "sure");
  c.quantities.erase(c.quantities.begin(), c.quantities.begin() + 2);
  EXPECT_EQ(c.largest_change()->name, "angle") << "better than none";
}

TEST(HistoryPages, DifferencesAreDrawnToTheScaleOfTheTable) {
  const std::string page = diff_page_with("x ");
  EXPECT_EQ(occurrences(page, "<div class=\"difference "), 9U);
  EXPECT_EQ(occurrences(page, "<div class=\"difference changed\">"), 1U);
  const std::size_t at = page.find("<div class=\"difference changed\">");
  const std::string row = page.substr(at, page.find("</div>", at) - at);
  // The zero is in the middle of 400, and the whole interval to the right of it.
  EXPECT_NE(row.find("class=\"zero\" d=\"M200.0 "), std::string::npos) << row;
  const std::size_t path = row.find("class=\"interval\" d=\"M") + 21;
  EXPECT_GT(std::stod(row.substr(path)), 200) << row;
}

TEST(HistoryPages, BothLoopsBeginAtTheirLargestAngle) {
  const auto all = history_with("x ");
  const auto c = history::compare(all[0], all[20], {10, 2}, false);
  const auto json = calibration::Json::parse(
      report::viewer::compared_curves_json(c, simple_curves(0), simple_curves(0.1)));
  ASSERT_EQ(json["loops"].size(), 2U);
  const auto& b = json["loops"][1];
  EXPECT_EQ(b["q"], calibration::Json::parse("[10, 0, -10, 0, 10]"));
  EXPECT_EQ(b["T"], calibration::Json::parse("[3.9, 3.7, 3.8, 4.1, 3.9]"));
  EXPECT_EQ(b["t"], calibration::Json::parse("[0, 90, 180, 270, 360]"));
  EXPECT_TRUE(json["loops"][0]["shown"] == true && b["shown"] == true);
  EXPECT_NE(json["loops"][0]["style"], b["style"]);
  EXPECT_EQ(report::viewer::compared_curves_json(c, simple_curves(0), {}), "");
}

TEST(HistoryPages, BothFrictionCurvesAreStretchesOfTheRunsBySpeed) {
  const auto all = history_with("x ");
  const auto c = history::compare(all[0], all[20], {10, 2}, false);
  calibration::RecordedCurves a = simple_curves(0);
  a.loops.clear();
  a.friction = {"midline", false, {20, -20, 10}, {0.5, -0.4, 0.3}, {0.01, 0.02, NAN}, {}};
  calibration::RecordedCurves b = simple_curves(0);
  b.friction = {"midline", false, {15}, {0.6}, {0.01}, {}};
  const auto json = calibration::Json::parse(report::viewer::compared_curves_json(c, a, b));
  EXPECT_TRUE(json["loops"].empty()) << "not both have one";
  const auto& runs = json["runs"];
  EXPECT_EQ(runs["w"], calibration::Json::parse("[-20, 10, 20, 15]"));
  EXPECT_EQ(runs["value"], calibration::Json::parse("[-0.4, 0.3, 0.5, 0.6]"));
  EXPECT_EQ(runs["half"], calibration::Json::parse("[0.02, null, 0.01, 0.01]"));
  EXPECT_EQ(json["quantities"]["f"]["unit"], "N·m");
  EXPECT_EQ(runs["value_texts"][0], "−0.400 ± 0.020\u00a0N·m");
  EXPECT_EQ(runs["value_texts"][1].get<std::string>().find("±"), std::string::npos);
  ASSERT_EQ(json["curves"].size(), 2U);
  EXPECT_EQ(json["curves"][0]["to"], json["curves"][1]["from"]);
  EXPECT_EQ(json["curves"][1]["to"], 4);
  EXPECT_NE(json["curves"][0]["style"], json["curves"][1]["style"]);
  b.friction.speed_rad_s.clear();
  EXPECT_EQ(report::viewer::compared_curves_json(c, a, b), "");
}

TEST(HistoryPages, TablesHaveTheCellsOfTheirColumns) {
  const auto all = history_with("x ");
  const auto c = history::compare(all[0], all[20], {10, 2}, false);
  const report::elements::Table changes = report::timeline::compared_quantities_table(c);
  for (const report::elements::Row& row : changes.rows)
    ASSERT_EQ(row.cells.size(), changes.columns.size());
  EXPECT_EQ(changes.rows[0].cells.front(), "x coulomb_torque [N·m]");
  EXPECT_EQ(changes.rows[0].cells.back(), "changed");
  EXPECT_EQ(changes.rows[6].cells.back(), "no change seen");
  const report::elements::Table conditions = report::timeline::compared_conditions_table(c);
  for (const report::elements::Row& row : conditions.rows) EXPECT_EQ(row.cells.size(), 3U);
  const report::elements::Table trend =
      report::timeline::trend_table(history::joint_trends(all, {}).front(), "t");
  for (const report::elements::Row& row : trend.rows)
    EXPECT_EQ(row.cells.size(), trend.columns.size());
}

TEST(HistoryPages, OneCalibrationAndNoFigureMakeAPageToo) {
  auto all = history_with("x ");
  all.resize(1);
  const auto trends = history::joint_trends(all, {});
  const std::string page = report::timeline::trend_page(
      trends, sample_provenance(), figures::timeline::trend_figures(trends), {});
  EXPECT_NE(page.find("TOO FEW YET"), std::string::npos);
  EXPECT_NE(page.find("This figure is missing"), std::string::npos);
}

TEST(HistoryFigures, ShowEveryCalibrationOnce) {
  auto all = history_with("x ");
  all[3].quantities[0].verdict = calibration::Verdict::doubtful;
  const auto trends = history::joint_trends(all, {});
  const auto figures = figures::timeline::trend_figures(trends);
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

TEST(HistoryFigures, WhatIsFarOffDoesNotSquashTheRest) {
  auto all = history_with("x ");
  constexpr std::size_t gravity = 6;  // without a change
  const auto axis_of = [&](const char* name) {
    for (const figures::ReportFigure& f :
         figures::timeline::trend_figures(history::joint_trends(all, {}))) {
      if (f.title.find(name) != std::string::npos) return f.figure.panels.front();
    }
    return render::figure::Panel{};
  };
  const std::string name = all[0].quantities[gravity].name;
  EXPECT_FALSE(axis_of(name.c_str()).y.minimum) << "the axis is free";
  std::optional<statistics::Estimate>& far = all[20].quantities[gravity].estimate;
  ASSERT_TRUE(far);
  const double value = far->value;
  far = statistics::symmetric_estimate(0.2 * value, 0.001 * value);
  for (const auto verdict : {calibration::Verdict::usable, calibration::Verdict::doubtful}) {
    all[20].quantities[gravity].verdict = verdict;
    const render::figure::Panel panel = axis_of(name.c_str());
    ASSERT_TRUE(panel.y.minimum && panel.y.maximum);
    EXPECT_LT(*panel.y.maximum - *panel.y.minimum, 0.2 * (*panel.y.maximum));
    ASSERT_EQ(panel.point_labels.size(), 1U);
    EXPECT_EQ(panel.point_labels[0].text.find("↓ "), 0U) << panel.point_labels[0].text;
    EXPECT_GT(panel.point_labels[0].y, *panel.y.minimum);
    // The data of the figure keep it where it was.
    std::size_t as_measured = 0;
    for (const render::figure::Series& s : panel.series) {
      for (const double y : s.y) as_measured += y < *panel.y.minimum ? 1 : 0;
    }
    EXPECT_EQ(as_measured, 1U);
  }
  // A change that was found is shown whole.
  const render::figure::Panel changed = axis_of("coulomb_torque");
  EXPECT_TRUE(changed.point_labels.empty());
}

TEST(HistoryFigures, AChangeThatStandsComesFirst) {
  auto all = history_with("x ");
  for (calibration::Measured& m : all) std::swap(m.quantities[0], m.quantities[6]);
  const auto figures = figures::timeline::trend_figures(history::joint_trends(all, {}));
  EXPECT_EQ(figures.front().id, "trend-1-7");
  EXPECT_EQ(figures[1].id, "trend-1-1");
}

TEST(HistoryFigures, OfTwoCalibrationsNeedBoth) {
  const auto all = history_with("x ");
  const auto c = history::compare(all[0], all[1], {}, false);
  EXPECT_EQ(figures::timeline::comparison_figures(c, simple_curves(0), simple_curves(0)).size(),
            2U);
  EXPECT_TRUE(figures::timeline::comparison_figures(c, simple_curves(0), {}).empty());
  calibration::RecordedCurves old = simple_curves(0);
  old.loops.clear();
  EXPECT_EQ(figures::timeline::comparison_figures(c, old, simple_curves(0)).size(), 1U);
}

}  // namespace
}  // namespace tribolog::test::history_pages_test
