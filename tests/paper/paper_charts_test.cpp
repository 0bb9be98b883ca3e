// What the charts of figures 1, 2 and 5 show, and that they can be read.

#include "paper/charts/paper_charts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "paper/figure_checks.h"

namespace tribolog::paper::paper_charts_test {
namespace {

const std::vector<figures::ReportFigure>& charts() {
  static const std::vector<figures::ReportFigure> all{
      charts::static_friction_figure(charts::stribeck_at_joint_scale()),
      charts::linear_zone_figure(charts::linear_zone_at_joint_scale()),
      charts::presliding_hysteresis_figure(charts::loops_of_figure_5({}))};
  return all;
}

// Torques of these figures are of the order of 1 N·m; both sides round a few operations.
constexpr double rounding = 1e-9;

using Direction = render::figure::ReferenceLine::Direction;

std::vector<double> lines_at(const render::figure::Panel& panel, Direction direction) {
  std::vector<double> out;
  for (const render::figure::ReferenceLine& line : panel.reference_lines) {
    if (line.direction == direction) out.push_back(line.at);
  }
  std::sort(out.begin(), out.end());
  return out;
}

/// All points of the solid curves.
std::vector<std::pair<double, double>> curve_of(const render::figure::Panel& panel) {
  std::vector<std::pair<double, double>> out;
  for (const render::figure::Series& series : panel.series) {
    if (series.style != render::figure::LineStyle::solid) continue;
    for (std::size_t i = 0; i < series.x.size(); ++i) out.emplace_back(series.x[i], series.y[i]);
  }
  return out;
}

void expect_odd(const render::figure::Panel& panel) {
  const auto curve = curve_of(panel);
  ASSERT_FALSE(curve.empty());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto& [x, y] = curve[i];
    const auto& [mirrored_x, mirrored_y] = curve[curve.size() - 1 - i];
    EXPECT_NEAR(mirrored_x, -x, rounding);
    EXPECT_NEAR(mirrored_y, -y, rounding);
  }
}

const render::figure::Series& styled(const render::figure::Panel& panel,
                                     render::figure::LineStyle style) {
  const auto found =
      std::find_if(panel.series.begin(), panel.series.end(),
                   [&](const render::figure::Series& one) { return one.style == style; });
  if (found == panel.series.end()) throw std::runtime_error("there is no such line");
  return *found;
}

TEST(PaperCharts, AreThePapersFigures) {
  std::vector<int> numbers;
  for (const figures::ReportFigure& one : charts()) numbers.push_back(one.paper_number.value_or(0));
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 5}));
}

TEST(PaperCharts, AreCompleteInWords) { test::expect_complete_in_words(charts()); }

TEST(PaperCharts, ComeOutWholeAndWithoutAWarning) { test::expect_drawn_whole(charts()); }

TEST(PaperCharts, SayWhoseTheParametersAre) {
  for (const int i : {0, 1}) {
    EXPECT_NE(charts()[i].caption.find("parameters are ours"), std::string::npos);
  }
}

TEST(PaperCharts, HaveUnitsOnTheirAxes) {
  for (const figures::ReportFigure& one : charts()) {
    for (const render::figure::Panel& panel : one.figure.panels) {
      EXPECT_EQ(panel.x.title.back(), ']') << panel.x.title;
      EXPECT_EQ(panel.y.title.back(), ']') << panel.y.title;
    }
  }
}

// Any law, so that nothing in the figure can be a constant of the paper's joint.
const friction::StribeckFriction stribeck({{1.0, 1.6, 0.5, 2.0}, 0.2});

TEST(StaticFrictionFigure, JumpsAtRestFromBreakAwayToBreakAway) {
  const render::figure::Panel panel = charts::static_friction_figure(stribeck).figure.panels.at(0);
  expect_odd(panel);
  double before = -1e9;
  double after = 1e9;
  for (const auto& [x, y] : curve_of(panel)) {
    EXPECT_NE(x, 0) << "at rest the law has no value";
    if (x < 0) before = std::max(before, x);
    if (x > 0) after = std::min(after, x);
    if (std::abs(x) < 1e-6) {
      EXPECT_NEAR(std::abs(y), 1.6, 1e-6);
    }
    EXPECT_GT(x * y, 0) << "friction resists";
  }
  EXPECT_LT(after - before, 1e-6);
  const render::figure::Series& rest = styled(panel, render::figure::LineStyle::dot);
  EXPECT_EQ(rest.x, (std::vector<double>{0, 0}));
  EXPECT_EQ(rest.y, (std::vector<double>{-1.6, 1.6}));
  EXPECT_NE(rest.marker, render::figure::Marker::none);
}

TEST(StaticFrictionFigure, MarksItsLevels) {
  const render::figure::Panel panel = charts::static_friction_figure(stribeck).figure.panels.at(0);
  EXPECT_EQ(lines_at(panel, Direction::horizontal), (std::vector<double>{-1.6, -1.0, 1.0, 1.6}));
  EXPECT_EQ(lines_at(panel, Direction::vertical), (std::vector<double>{-0.5, 0.5}));
}

// The dashed line is what is left of the curve far from rest.
TEST(StaticFrictionFigure, TendsToTheViscousLine) {
  const render::figure::Panel panel = charts::static_friction_figure(stribeck).figure.panels.at(0);
  const auto curve = curve_of(panel);
  std::size_t looked_at = 0;
  for (const render::figure::Series& line : panel.series) {
    if (line.style != render::figure::LineStyle::dash) continue;
    ++looked_at;
    const double slope = (line.y[1] - line.y[0]) / (line.x[1] - line.x[0]);
    EXPECT_NEAR(slope, 0.2, rounding);
    EXPECT_NEAR(std::abs(line.y[0]), 1.0, rounding);
    const auto& end = line.x[1] > 0 ? curve.back() : curve.front();
    EXPECT_NEAR(end.first, line.x[1], rounding);
    EXPECT_NEAR(end.second, line.y[1], 1e-6);
  }
  EXPECT_GT(looked_at, 0U);
}

const friction::ThresholdSpeedFriction threshold({1.0, 1.6, 2.0, 0.2, 1e-3});

TEST(LinearZoneFigure, HasTheSameLevelsAndNoJump) {
  const render::figure::Panel panel = charts::linear_zone_figure(threshold).figure.panels.at(0);
  expect_odd(panel);
  EXPECT_EQ(lines_at(panel, Direction::horizontal), (std::vector<double>{-1.6, -1.0, 1.0, 1.6}));
  EXPECT_EQ(lines_at(panel, Direction::vertical), (std::vector<double>{-0.5, 0.5}));
  const render::figure::Series& line = styled(panel, render::figure::LineStyle::solid);
  EXPECT_LT(line.x.front(), -1);  // one line from end to end
  EXPECT_GT(line.x.back(), 1);
}

TEST(LinearZoneFigure, ShowsTheLinearZoneEnlarged) {
  const render::figure::Panel panel = charts::linear_zone_figure(threshold).figure.panels.at(1);
  expect_odd(panel);
  EXPECT_NE(panel.x.title.find("[mrad/s]"), std::string::npos) << panel.x.title;
  EXPECT_EQ(lines_at(panel, Direction::vertical), (std::vector<double>{-1, 1}));
  const double top = threshold.torque_Nm(1e-3);
  for (const auto& [x, y] : curve_of(panel)) {
    if (std::abs(x) <= 1) {
      EXPECT_NEAR(y, x * top, rounding) << x;
    } else {
      EXPECT_NEAR(std::abs(y), top, 1e-2) << x;
    }
  }
  ASSERT_EQ(panel.bands.size(), 1U);
  EXPECT_EQ(panel.bands[0].x, (std::vector<double>{-1, 1}));
}

TEST(LinearZoneFigure, NeedsAStribeckEffect) {
  EXPECT_THROW(
      charts::linear_zone_figure(friction::ThresholdSpeedFriction({1.0, 1.6, 0.0, 0.2, 1e-3})),
      std::invalid_argument);
}

// Both laws at the paper's joint are of one contact.
TEST(JointScale, HasTheSameContactInBothLaws) {
  const friction::StribeckFriction one = charts::stribeck_at_joint_scale();
  const friction::ThresholdSpeedFriction two = charts::linear_zone_at_joint_scale();
  EXPECT_NEAR(one.torque_Nm(1e-9), 0.884, 1e-6);
  EXPECT_NEAR(one.torque_Nm(300), 1.17, 0.01);
  EXPECT_NEAR(two.torque_Nm(300), one.torque_Nm(300), rounding);
  EXPECT_NEAR(two.torque_Nm(2 * two.parameters().threshold_rad_s), 0.884, 1e-3);
}

// As printed: three loops of friction on one pair of axes, the travel that table 1 gives each.
TEST(PreslidingFigure, ShowsThePrintedLoopsOfFrictionOnOnePairOfAxes) {
  const render::figure::Panel& panel = charts().at(2).figure.panels.at(0);
  ASSERT_EQ(panel.series.size(), 3U);
  const double amplitudes_N[] = {1.425, 1.3, 1};
  const double travels_um[] = {54.95, 39.59, 24.14};
  for (std::size_t i = 0; i < 3; ++i) {
    const render::figure::Series& loop = panel.series[i];
    const auto [left, right] = std::minmax_element(loop.x.begin(), loop.x.end());
    const auto [low, high] = std::minmax_element(loop.y.begin(), loop.y.end());
    EXPECT_NEAR(*right - *left, travels_um[i], 0.005);
    EXPECT_NEAR(*high, amplitudes_N[i], 1e-6);
    EXPECT_NEAR(*low, -amplitudes_N[i], 1e-6);
    EXPECT_NEAR(loop.y.front(), loop.y.back(), 1e-6);
    EXPECT_FALSE(loop.direction_arrows_at.empty());
  }
}

TEST(PreslidingFigure, SaysWhatThePrintedFrequenciesWouldAskOfThoseLoops) {
  const std::string& text = charts().at(2).how_to_read;
  EXPECT_NE(text.find("reaches only 1.419 N at 1 Hz"), std::string::npos) << text;
}

TEST(PreslidingFigure, ShowsOneClosedLoopOfForceAPanelOnOneAxis) {
  const render::figure::Figure& figure = charts().at(2).figure;
  ASSERT_EQ(figure.panels.size(), 4U);
  for (std::size_t i = 1; i < figure.panels.size(); ++i) {
    const render::figure::Panel& panel = figure.panels[i];
    EXPECT_EQ(panel.y.minimum, figure.panels[1].y.minimum);
    EXPECT_EQ(panel.y.maximum, figure.panels[1].y.maximum);
    const render::figure::Series& loop = styled(panel, render::figure::LineStyle::solid);
    const auto [left, right] = std::minmax_element(loop.x.begin(), loop.x.end());
    EXPECT_NEAR(loop.x.front(), loop.x.back(), 1e-6 * (*right - *left));
    EXPECT_NEAR(*left, -*right, 1e-9 * *right);
    EXPECT_FALSE(loop.direction_arrows_at.empty());
    for (const double force : loop.y) EXPECT_LT(std::abs(force), *panel.y.maximum);
  }
}

// The same widths in the axes' units and in the words above them.
TEST(PreslidingFigure, HasThePrefixOfEachWidth) {
  const render::figure::Figure& figure = charts().at(2).figure;
  const double widths[] = {8.18, 172.6, 34.5};
  const char* units[] = {"[mm]", "[µm]", "[µm]"};
  for (std::size_t i = 0; i < 3; ++i) {
    const render::figure::Panel& panel = figure.panels[i + 1];
    const render::figure::Series& loop = styled(panel, render::figure::LineStyle::solid);
    const auto [left, right] = std::minmax_element(loop.x.begin(), loop.x.end());
    EXPECT_NEAR(*right - *left, widths[i], 1e-3 * widths[i]);
    EXPECT_NE(panel.x.title.find(units[i]), std::string::npos) << panel.x.title;
  }
  EXPECT_EQ(figure.panels[1].title, "1.425 N at 1 Hz: 8.18 mm wide, up to 47.2 mm/s");
}

TEST(PreslidingFigure, SaysWhetherItIsPreSliding) {
  const auto caption = [](const std::vector<simulate::SinusoidalForce>& forces) {
    charts::PreslidingLoops loops = charts::loops_of_figure_5({});
    loops.by_force = simulate::presliding_loops({}, forces);
    return charts::presliding_hysteresis_figure(loops).caption;
  };
  const auto says = [](const std::string& text, const char* what) {
    return text.find(what) != std::string::npos;
  };
  EXPECT_TRUE(says(charts().at(2).caption, "none of the loops is pure pre-sliding"));
  EXPECT_TRUE(says(caption({{0.5, 1}}), "pure pre-sliding"));
  EXPECT_FALSE(says(caption({{0.5, 1}}), "none"));
  EXPECT_TRUE(says(caption({{0.5, 1}, {1.3, 10}}), "1 of the 2 loops is pure pre-sliding"));
}

TEST(PreslidingFigure, NeedsALoop) {
  EXPECT_THROW(charts::presliding_hysteresis_figure({}), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::paper::paper_charts_test
