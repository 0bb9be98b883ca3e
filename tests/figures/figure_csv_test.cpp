#include "figures/figure_csv.h"

#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <gtest/gtest.h>

#include "wording/language.h"
#include "wording/tr.h"

namespace tribolog::figure_csv_test {
namespace {

constexpr std::size_t all_rows = 1000;

figures::ReportFigure figure_of(std::vector<render::figure::Panel> panels) {
  figures::ReportFigure figure;
  figure.id = "fig-1";
  figure.title = "Loop";
  figure.figure.panels = std::move(panels);
  return figure;
}

render::figure::Panel panel_of(std::vector<double> x, std::vector<double> y,
                               const std::string& label) {
  render::figure::Panel panel;
  panel.x.title = "joint angle q [mrad]";
  panel.y.title = "T_{f} [N·m]";
  render::figure::Series series;
  series.label = label;
  series.x = std::move(x);
  series.y = std::move(y);
  panel.series.push_back(series);
  return panel;
}

TEST(FigureCsv, SaysEverythingThatIsDrawn) {
  render::figure::Panel panel =
      panel_of({1, 2, std::nan("")}, {0.1, -1e-7, 3}, "T_{ARM}, measured");
  panel.title = "first";
  panel.bands.push_back({"95 %", {1}, {0.5}, {1.5}, {}});
  panel.error_bars.push_back({4, 1, 2, {}});
  panel.point_labels.push_back({1, 0.1, "A", {}, {}});
  panel.y.names = {{1, "T_{s}"}};
  panel.reference_lines.push_back(
      {render::figure::ReferenceLine::Direction::horizontal, 7, "limit", {}, {}});
  EXPECT_EQ(figures::figure_csv(figure_of({panel, panel_of({5}, {6}, "")}), all_rows),
            "# fig-1: Loop\n"
            "# panel 1 (first): x = joint angle q [mrad]; y = T_f [N·m]\n"
            "# panel 1, T_ARM, measured: 1 of 3 samples are no numbers\n"
            "# panel 2: x = joint angle q [mrad]; y = T_f [N·m]\n"
            "panel,what,name,x,y,low,high\n"
            "1,curve,\"T_ARM, measured\",1,0.1,,\n"
            "1,curve,\"T_ARM, measured\",2,-1e-07,,\n"
            "1,interval,95 %,1,,0.5,1.5\n"
            "1,interval,,4,,1,2\n"
            "1,name,T_s,,1,,\n"
            "1,point,A,1,0.1,,\n"
            "1,line,limit,,7,,\n"
            "2,curve,,5,6,,\n");
}

TEST(FigureCsv, ThinnedCurvesKeepTheirExtremes) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 24'000; ++i) {
    x.push_back(i);
    y.push_back(i == 12'345 ? 99 : i == 777 ? -99 : std::sin(1e-3 * i));
  }
  const std::string text = figures::figure_csv(figure_of({panel_of(x, y, "log")}), 1000);
  EXPECT_NE(text.find("1,curve,log,12345,99,,\n"), std::string::npos);
  EXPECT_NE(text.find("1,curve,log,777,-99,,\n"), std::string::npos);
  EXPECT_NE(text.find("# panel 1, log: 1000 of 24000 samples, the lowest and highest of each "
                      "block\n"),
            std::string::npos);
  std::istringstream lines(text);
  double last = -1;
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("1,curve,log,")) continue;
    const double at = std::stod(line.substr(12));
    EXPECT_GT(at, last) << "in the order of the samples";
    last = at;
    ++rows;
  }
  EXPECT_EQ(rows, 1000U);
}

TEST(FigureCsv, SaysWhereCurvesBreakAndWhatNoLineJoins) {
  const double gap = std::nan("");
  render::figure::Panel panel =
      panel_of({gap, 1, 2, 3, gap, 5, 6}, {0, 1, gap, gap, 4, 5, gap}, "loop");
  render::figure::Series marks = panel_of({7, 8}, {1, 2}, "points").series.front();
  marks.style = render::figure::LineStyle::none;
  panel.series.push_back(marks);
  panel.y.logarithmic = true;
  panel.bands.push_back({"95 %", {1, 2, 3}, {1, gap, 1}, {2, 2, 2}, {}});
  EXPECT_EQ(figures::figure_csv(figure_of({panel}), all_rows),
            "# fig-1: Loop\n"
            "# panel 1: x = joint angle q [mrad]; y = T_f [N·m] (logarithmic)\n"
            "# panel 1, loop: 5 of 7 samples are no numbers\n"
            "# panel 1, 95 %: 1 of 3 samples are no numbers\n"
            "panel,what,name,x,y,low,high\n"
            "1,curve,loop,1,1,,\n"
            "1,curve,loop,,,,\n"
            "1,curve,loop,5,5,,\n"
            "1,marks,points,7,1,,\n"
            "1,marks,points,8,2,,\n"
            "1,interval,95 %,1,,1,2\n"
            "1,interval,95 %,,,,\n"
            "1,interval,95 %,3,,1,2\n");
}

TEST(FigureCsv, BreaksStayWhereCurvesAreThinned) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 10'000; ++i) {
    x.push_back(i);
    y.push_back(i == 5'000 ? std::nan("") : std::sin(1e-3 * i));
  }
  const std::string text = figures::figure_csv(figure_of({panel_of(x, y, "log")}), 1000);
  EXPECT_NE(text.find("\n1,curve,log,,,,\n"), std::string::npos);
  EXPECT_NE(text.find("# panel 1, log: 1 of 10000 samples are no numbers\n"), std::string::npos);
}

TEST(FigureCsv, DatesAreDates) {
  render::figure::Panel panel = panel_of({0, 20'779.25}, {1, 2}, "F_{c}");
  panel.x.dates = true;
  const std::string text = figures::figure_csv(figure_of({panel}), all_rows);
  EXPECT_NE(text.find("1,curve,F_c,1970-01-01T00:00:00Z,1,,\n"), std::string::npos);
  EXPECT_NE(text.find("1,curve,F_c,2026-11-22T06:00:00Z,2,,\n"), std::string::npos);
}

TEST(FigureCsv, NoTextBreaksOutOfItsCell) {
  figures::ReportFigure figure = figure_of({panel_of({1}, {2}, "=HYPERLINK(\"x\")\n# evil,1")});
  figure.title = "two\nlines";
  const std::string text = figures::figure_csv(figure, all_rows);
  EXPECT_NE(text.find("# fig-1: two lines\n"), std::string::npos);
  EXPECT_NE(text.find("1,curve,\"'=HYPERLINK(\"\"x\"\") # evil,1\",1,2,,\n"), std::string::npos);
}

TEST(FigureCsv, IsTheSameInEveryLanguage) {
  const auto make = [] {
    return std::vector{figure_of({panel_of({1}, {2}, wording::tr("mid-line"))})};
  };
  const std::vector<figures::ReportFigure> english = figures::figures_in({}, make);
  EXPECT_EQ(english.front().english_csv, "");
  for (const wording::Language& language : wording::languages()) {
    if (language.is_english()) continue;
    const figures::ReportFigure figure = figures::figures_in(language, make).front();
    EXPECT_NE(figure.figure.panels.front().series.front().label, "mid-line") << language.code;
    EXPECT_EQ(figure.english_csv, figures::figure_csv(english.front(), all_rows));
  }
}

TEST(FigureCsv, DrawingsShowNoData) {
  figures::ReportFigure figure = figure_of({});
  EXPECT_EQ(figures::figure_csv(figure, all_rows), "");
  figure = figure_of({panel_of({1}, {2}, "")});
  figure.figure.diagram.emplace();
  EXPECT_EQ(figures::figure_csv(figure, all_rows), "");
}

}  // namespace
}  // namespace tribolog::figure_csv_test
