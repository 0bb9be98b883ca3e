#include <cmath>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/composition/figure_layout.h"
#include "render/example_figures.h"
#include "render/legibility/contrast.h"
#include "render/legibility/panel_content.h"
#include "render/legibility/text_collisions.h"
#include "wording/words.h"

namespace tribolog::render::layout_test {
namespace {

const text::Font& font() {
  static const text::Font the_font;
  return the_font;
}

struct Placed {
  figure::Owner owner;
  figure::PixelBox box;
  std::string text;
};

std::vector<Placed> texts(const figure::DrawList& list) {
  std::vector<Placed> out;
  for (const figure::Primitive& one : list.primitives) {
    if (const auto* run = std::get_if<figure::TextRun>(&one)) {
      out.push_back({run->owner, run->box, run->text});
    }
  }
  return out;
}

void expect_none(const legibility::Findings& findings, const std::string& id) {
  for (const legibility::Finding& one : findings)
    ADD_FAILURE() << id << ": " << legibility::in_words(one);
}

TEST(Layout, KeepsTextsApartAndInsideThePicture) {
  std::vector<figure::Figure> all = examples::nasty();
  for (const figure::Figure& figure :
       {examples::plain(), examples::hysteresis(), examples::stacked(), examples::many_curves(10),
        examples::noisy_sweep()}) {
    all.push_back(figure);
  }
  for (const figure::Figure& figure : all) {
    const figure::DrawList list = composition::lay_out(figure, font());
    expect_none(legibility::overlapping_texts(list), figure.id);
    expect_none(legibility::texts_off_the_picture(list), figure.id);
    expect_none(legibility::data_under_legends(list), figure.id);
  }
}

TEST(Layout, KeepsDataInsideTheAxes) {
  for (const figure::Figure& figure : examples::nasty()) {
    expect_none(legibility::data_outside_axes(composition::lay_out(figure, font())), figure.id);
  }
}

TEST(Layout, PutsALegendWithoutRoomBelow) {
  const figure::DrawList list = composition::lay_out(examples::many_curves(12), font());
  int entries = 0;
  for (const Placed& one : texts(list)) {
    if (one.owner.role != figure::Role::legend_text) continue;
    ++entries;
    EXPECT_GT(one.box.top, list.plots[0].bottom);
  }
  EXPECT_EQ(entries, 12);
}

TEST(Layout, LabelsSixPointsOfWhichThreeAreClose) {
  const figure::DrawList list = composition::lay_out(examples::hysteresis(), font());
  std::map<int, figure::PixelPoint> points;
  std::map<int, figure::PixelBox> names;
  for (const figure::Primitive& one : list.primitives) {
    if (const auto* marker = std::get_if<figure::Markers>(&one);
        marker != nullptr && marker->owner.role == figure::Role::label_marker) {
      points[marker->owner.index] = marker->centres.at(0);
    }
    if (const auto* run = std::get_if<figure::TextRun>(&one);
        run != nullptr && run->owner.role == figure::Role::label_text) {
      names[run->owner.index] = run->box;
    }
  }
  ASSERT_EQ(points.size(), 6U);
  ASSERT_EQ(names.size(), 6U);
  for (const auto& [index, box] : names) {
    for (const auto& [other, point] : points) {
      EXPECT_FALSE(box.grown(3).contains(point)) << "text " << index << " on point " << other;
    }
  }
}

TEST(Layout, BreaksTheLineAtMissingSamplesAndCountsThem) {
  figure::Figure figure = examples::plain();
  auto& series = figure.panels[0].series[0];
  series.x = {0, 1, 2, 3, 4, 5};
  series.y = {0, 1, std::nan(""), 1, 2, INFINITY};
  const figure::DrawList list = composition::lay_out(figure, font());
  int lines = 0;
  for (const figure::Primitive& one : list.primitives) {
    lines += figure::owner_of(one).role == figure::Role::series ? 1 : 0;
  }
  EXPECT_EQ(lines, 2);
  ASSERT_EQ(list.warnings.size(), 1U);
  EXPECT_EQ(wording::words(list.warnings[0]),
            "series 'line': dropped 2 of 6 samples that are not finite");
}

TEST(Layout, SaysNoDataAndWarnsOfASeriesWithoutAny) {
  figure::Figure figure = examples::plain();
  figure.panels[0].series[0].y.assign(4, std::nan(""));
  const figure::DrawList list = composition::lay_out(figure, font());
  bool said = false;
  for (const Placed& one : texts(list)) said = said || one.text == "no data";
  EXPECT_TRUE(said);
  ASSERT_EQ(list.warnings.size(), 1U);

  figure.panels[0].series.clear();
  EXPECT_TRUE(composition::lay_out(figure, font()).warnings.empty())
      << "an empty panel is no fault";
}

TEST(Layout, SharesOneAxisBetweenStackedPanels) {
  const figure::DrawList list = composition::lay_out(examples::stacked(), font());
  ASSERT_EQ(list.plots.size(), 3U);
  EXPECT_EQ(list.plots[0].left, list.plots[2].left);
  EXPECT_EQ(list.plots[0].right, list.plots[2].right);
  int titles = 0;
  for (const Placed& one : texts(list)) {
    titles += one.owner.role == figure::Role::axis_title && one.text == "time t [s]" ? 1 : 0;
  }
  EXPECT_EQ(titles, 1);
}

TEST(Layout, MapsDataLinearly) {
  figure::Figure figure = examples::plain();
  auto& panel = figure.panels[0];
  panel.series[0] = examples::line({0, 10}, {0, 100});
  panel.x.minimum = 0;
  panel.x.maximum = 10;
  panel.y.minimum = 0;
  panel.y.maximum = 200;
  const figure::DrawList list = composition::lay_out(figure, font());
  std::size_t looked_at = 0;
  for (const figure::Primitive& one : list.primitives) {
    const auto* line = std::get_if<figure::Polyline>(&one);
    if (line == nullptr || line->owner.role != figure::Role::series) continue;
    ++looked_at;
    EXPECT_NEAR(line->points.front().x, list.plots[0].left, 1e-9);
    EXPECT_NEAR(line->points.front().y, list.plots[0].bottom, 1e-9);
    EXPECT_NEAR(line->points.back().x, list.plots[0].right, 1e-9);
    EXPECT_NEAR(line->points.back().y, list.plots[0].centre().y, 1e-9);
  }
  EXPECT_GT(looked_at, 0U);
}

TEST(Layout, DividesBothDirectionsInDecades) {
  figure::Figure figure = examples::plain();
  figure.panels[0].series[0] = examples::line({-100, -10, 0, 10, 100}, {0, 3, 1, 4, 2});
  figure.panels[0].x.linear_within = 0.1;
  const figure::DrawList list = composition::lay_out(figure, font());
  std::vector<double> x;
  for (const figure::Primitive& one : list.primitives) {
    const auto* line = std::get_if<figure::Polyline>(&one);
    if (line == nullptr || line->owner.role != figure::Role::series) continue;
    for (const figure::PixelPoint& point : line->points) x.push_back(point.x);
  }
  ASSERT_EQ(x.size(), 5U);
  const double decade = x[4] - x[3];
  EXPECT_NEAR(x[1] - x[0], decade, 1e-6 * decade);
  EXPECT_NEAR(x[2] - x[1], x[3] - x[2], 1e-6 * decade);
  const double beyond = std::asinh(1e3) - std::asinh(1e2);
  EXPECT_NEAR((x[3] - x[2]) / decade, std::asinh(1e2) / beyond, 1e-6);
}

TEST(Layout, NamesSeriesWhereTheyEnd) {
  figure::Figure figure = examples::plain();
  figure::Panel& panel = figure.panels[0];
  panel.series.clear();
  panel.bands.clear();
  const double ends[] = {1.0, 1.001, 1.002, 9.0};
  for (int k = 0; k < 4; ++k) {
    panel.series.push_back(examples::line({0, 1}, {5, ends[k]}));
    panel.series.back().label = "curve " + std::to_string(k);
    // Goes on without a name of its own.
    panel.series.push_back(examples::line({1, 2}, {ends[k], 10 - ends[k]}));
    panel.series.back().label.clear();
  }
  panel.labels_at_ends = true;
  const figure::DrawList list = composition::lay_out(figure, font());
  std::map<std::string, double> height;
  for (const Placed& one : texts(list)) {
    if (one.owner.role != figure::Role::legend_text) continue;
    EXPECT_GT(one.box.left, list.plots[0].right);
    EXPECT_LT(one.box.right, list.width);
    height[one.text] = one.box.centre().y;
  }
  ASSERT_EQ(height.size(), 4U);
  EXPECT_GT(height["curve 3"], height["curve 0"] + list.plots[0].height() / 2);
  // Three that end at almost the same height stand below each other, in its order.
  EXPECT_LT(height["curve 0"] + 10, height["curve 1"]);
  EXPECT_LT(height["curve 1"] + 10, height["curve 2"]);
  EXPECT_LT(height["curve 2"] - height["curve 0"], 120);
}

TEST(Layout, KeepsTheTextsOfReferenceLinesOffSingleMarkers) {
  figure::Figure figure = examples::plain();
  figure::Panel& panel = figure.panels[0];
  panel.x.minimum = panel.y.minimum = 0;
  panel.x.maximum = panel.y.maximum = 10;
  figure::Series markers = examples::line({}, {}, "");
  for (double x = 3.5; x < 10; x += 1) {  // a text is wider than their distance
    for (const double beside : {-0.25, 0.25}) {
      markers.x.push_back(x);
      markers.y.push_back(5 + beside);
    }
  }
  markers.style = figure::LineStyle::none;
  markers.marker = figure::Marker::circle;
  markers.marker_size_px = 6;
  panel.series = {markers};
  panel.reference_lines = {
      {figure::ReferenceLine::Direction::horizontal, 5, "recommended, by far"}};
  const figure::DrawList list = composition::lay_out(figure, font());
  expect_none(legibility::markers_under_texts(list), figure.id);
  std::size_t looked_at = 0;
  for (const Placed& one : texts(list)) {
    if (one.owner.role != figure::Role::reference_text) continue;
    ++looked_at;
    EXPECT_LT(one.box.left, list.plots[0].centre().x) << "only there is room";
  }
  EXPECT_GT(looked_at, 0U);
}

TEST(Layout, WritesLettersDarkerThanTheirPoint) {
  figure::Figure figure = examples::plain();
  figure.panels[0].point_labels = {{2, 2, "chosen", figure::palette::orange}};
  const figure::DrawList list = composition::lay_out(figure, font());
  expect_none(legibility::faint_texts(list), figure.id);
  std::size_t looked_at = 0;
  for (const figure::Primitive& one : list.primitives) {
    if (figure::owner_of(one).role != figure::Role::label_marker) continue;
    ++looked_at;
    EXPECT_EQ(std::get<figure::Markers>(one).colour, figure::palette::orange);
  }
  EXPECT_GT(looked_at, 0U);
}

TEST(Layout, NamesStandInsteadOfNumbers) {
  figure::Figure figure = examples::plain();
  figure::Panel& panel = figure.panels[0];
  panel.y.minimum = 0;
  panel.y.maximum = 3;
  panel.y.names = {{1, "break-away torque T_{s}"}, {2, "mid-line"}, {7, "beyond the axis"}};
  const figure::DrawList list = composition::lay_out(figure, font());
  const figure::PixelBox plot = list.plots[0];
  std::map<std::string, figure::PixelBox> names;
  for (const Placed& one : texts(list)) {
    const bool is_left = one.box.right < plot.left;
    if (is_left && one.owner.role == figure::Role::tick_label) names[one.text] = one.box;
  }
  EXPECT_EQ(names.size(), 3U) << "two names, one of them with an index, and no number";
  ASSERT_EQ(names.count("mid-line"), 1U);
  EXPECT_NEAR(names["mid-line"].centre().y, plot.bottom - 2 * plot.height() / 3, 4);
  EXPECT_GE(names["break-away torque T"].left, 0);
}

TEST(Layout, RefusesImpossibleSizes) {
  figure::Figure figure = examples::plain();
  for (const int side : {-1, 0, 20, 100'000}) {
    figure.width_px = side;
    EXPECT_THROW(composition::lay_out(figure, font()), FigureError);
  }
}

TEST(Layout, DatesNeitherOverlapNorLeaveThePicture) {
  for (const double days : {0.3, 1.0, 3.0, 20.0, 80.0, 400.0, 1200.0, 9000.0}) {
    for (const int width : {700, 1600}) {
      figure::Figure figure;
      figure.id = "dates";
      figure.title = "Dates";
      figure.width_px = width;
      figure::Panel panel;
      panel.x.title = "measured on";
      panel.x.dates = true;
      panel.y.title = "y";
      figure::Series& series = panel.series.emplace_back();
      series.x = {20454, 20454 + days / 3, 20454 + days};
      series.y = {1, 3, 2};
      figure.panels = {panel};
      const figure::DrawList list = composition::lay_out(figure, font());
      expect_none(legibility::overlapping_texts(list), std::to_string(days));
      expect_none(legibility::texts_off_the_picture(list), std::to_string(days));
      std::size_t dates = 0;
      for (const Placed& one : texts(list)) {
        if (one.text.rfind("20", 0) == 0) ++dates;
      }
      EXPECT_GE(dates, 1U) << days << " days, " << width;
    }
  }
}

}  // namespace
}  // namespace tribolog::render::layout_test
