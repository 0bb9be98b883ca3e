#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "example_figures.h"

#include "error.h"
#include "render/layout/figure_layout.h"

namespace tribolog::render {
namespace {

const Font& font() {
  static const Font the_font;
  return the_font;
}

struct Placed {
  Owner owner;
  PixelBox box;
  std::string text;
};

std::vector<Placed> texts(const DrawList& list) {
  std::vector<Placed> out;
  for (const Primitive& one : list.primitives) {
    if (const auto* run = std::get_if<TextRun>(&one)) {
      out.push_back({run->owner, run->box, run->text});
    }
  }
  return out;
}

/// Texts of one owner may touch (a letter and its dot); others must keep apart.
void expect_nothing_overlaps(const DrawList& list, const std::string& id) {
  const auto all = texts(list);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (all[i].owner == all[j].owner) continue;
      EXPECT_LE(overlap_area(all[i].box, all[j].box), 1.0)
          << id << ": '" << all[i].text << "' and '" << all[j].text << "'";
    }
  }
}

void expect_nothing_is_clipped(const DrawList& list, const std::string& id) {
  const PixelBox picture{0, 0, static_cast<double>(list.width), static_cast<double>(list.height)};
  for (const Placed& one : texts(list)) {
    EXPECT_TRUE(picture.contains(one.box)) << id << ": '" << one.text << "'";
  }
}

/// No primitive of the data lies under the legend.
void expect_legend_hides_nothing(const DrawList& list, const std::string& id) {
  const std::set<Role> data{Role::series,      Role::series_marker,  Role::band,
                            Role::error_bar,   Role::reference_line, Role::label_marker,
                            Role::label_leader};
  for (const Primitive& one : list.primitives) {
    const auto* legend = std::get_if<Polygon>(&one);
    if (legend == nullptr || legend->owner.role != Role::legend_box) continue;
    const PixelBox box{legend->outline[0].x, legend->outline[0].y, legend->outline[2].x,
                       legend->outline[2].y};
    for (const Primitive& other : list.primitives) {
      if (data.count(owner_of(other).role) == 0) continue;
      if (const auto* line = std::get_if<Polyline>(&other)) {
        for (std::size_t i = 1; i < line->points.size(); ++i) {
          for (double t = 0; t <= 1; t += 0.01) {
            const PixelPoint p{
                line->points[i - 1].x + t * (line->points[i].x - line->points[i - 1].x),
                line->points[i - 1].y + t * (line->points[i].y - line->points[i - 1].y)};
            ASSERT_FALSE(box.contains(p)) << id;
          }
        }
      } else if (const auto* markers = std::get_if<Markers>(&other)) {
        for (const PixelPoint& p : markers->centres) ASSERT_FALSE(box.contains(p)) << id;
      }
    }
  }
}

TEST(Layout, KeepsTextsApartAndInsideThePicture) {
  std::vector<Figure> all = examples::nasty();
  for (const Figure& figure : {examples::plain(), examples::hysteresis(), examples::stacked(),
                               examples::many_curves(10), examples::noisy_sweep()}) {
    all.push_back(figure);
  }
  for (const Figure& figure : all) {
    const DrawList list = lay_out(figure, font());
    expect_nothing_overlaps(list, figure.id);
    expect_nothing_is_clipped(list, figure.id);
    expect_legend_hides_nothing(list, figure.id);
  }
}

TEST(Layout, KeepsDataInsideTheAxes) {
  for (const Figure& figure : examples::nasty()) {
    const DrawList list = lay_out(figure, font());
    for (const Primitive& one : list.primitives) {
      const auto* line = std::get_if<Polyline>(&one);
      if (line == nullptr || line->owner.role != Role::series) continue;
      const PixelBox plot = list.plots[static_cast<std::size_t>(line->owner.panel)].grown(0.01);
      for (const PixelPoint& p : line->points) EXPECT_TRUE(plot.contains(p)) << figure.id;
    }
  }
}

TEST(Layout, PutsALegendWithoutRoomBelow) {
  const DrawList list = lay_out(examples::many_curves(12), font());
  int entries = 0;
  for (const Placed& one : texts(list)) {
    if (one.owner.role != Role::legend_text) continue;
    ++entries;
    EXPECT_GT(one.box.top, list.plots[0].bottom);
  }
  EXPECT_EQ(entries, 12);
}

TEST(Layout, LabelsSixPointsOfWhichThreeAreClose) {
  const DrawList list = lay_out(examples::hysteresis(), font());
  std::map<int, PixelPoint> points;
  std::map<int, PixelBox> names;
  for (const Primitive& one : list.primitives) {
    if (const auto* marker = std::get_if<Markers>(&one);
        marker != nullptr && marker->owner.role == Role::label_marker) {
      points[marker->owner.index] = marker->centres.at(0);
    }
    if (const auto* run = std::get_if<TextRun>(&one);
        run != nullptr && run->owner.role == Role::label_text) {
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
  Figure figure = examples::plain();
  auto& series = figure.panels[0].series[0];
  series.x = {0, 1, 2, 3, 4, 5};
  series.y = {0, 1, std::nan(""), 1, 2, INFINITY};
  const DrawList list = lay_out(figure, font());
  int lines = 0;
  for (const Primitive& one : list.primitives) {
    lines += owner_of(one).role == Role::series ? 1 : 0;
  }
  EXPECT_EQ(lines, 2);
  ASSERT_EQ(list.warnings.size(), 1U);
  EXPECT_NE(list.warnings[0].find("dropped 2 of 6"), std::string::npos) << list.warnings[0];
}

TEST(Layout, SaysNoDataAndWarnsOfASeriesWithoutAny) {
  Figure figure = examples::plain();
  figure.panels[0].series[0].y.assign(4, std::nan(""));
  const DrawList list = lay_out(figure, font());
  bool said = false;
  for (const Placed& one : texts(list)) said = said || one.text == "no data";
  EXPECT_TRUE(said);
  ASSERT_EQ(list.warnings.size(), 1U);

  figure.panels[0].series.clear();
  EXPECT_TRUE(lay_out(figure, font()).warnings.empty()) << "an empty panel is no fault";
}

TEST(Layout, SharesOneAxisBetweenStackedPanels) {
  const DrawList list = lay_out(examples::stacked(), font());
  ASSERT_EQ(list.plots.size(), 3U);
  EXPECT_EQ(list.plots[0].left, list.plots[2].left);
  EXPECT_EQ(list.plots[0].right, list.plots[2].right);
  int titles = 0;
  for (const Placed& one : texts(list)) {
    titles += one.owner.role == Role::axis_title && one.text == "time t [s]" ? 1 : 0;
  }
  EXPECT_EQ(titles, 1);
}

TEST(Layout, MapsDataLinearly) {
  Figure figure = examples::plain();
  auto& panel = figure.panels[0];
  panel.series[0] = examples::line({0, 10}, {0, 100});
  panel.x.minimum = 0;
  panel.x.maximum = 10;
  panel.y.minimum = 0;
  panel.y.maximum = 200;
  const DrawList list = lay_out(figure, font());
  for (const Primitive& one : list.primitives) {
    const auto* line = std::get_if<Polyline>(&one);
    if (line == nullptr || line->owner.role != Role::series) continue;
    EXPECT_NEAR(line->points.front().x, list.plots[0].left, 1e-9);
    EXPECT_NEAR(line->points.front().y, list.plots[0].bottom, 1e-9);
    EXPECT_NEAR(line->points.back().x, list.plots[0].right, 1e-9);
    EXPECT_NEAR(line->points.back().y, list.plots[0].centre().y, 1e-9);
  }
}

TEST(Layout, RefusesImpossibleSizes) {
  Figure figure = examples::plain();
  for (const int side : {-1, 0, 20, 100'000}) {
    figure.width_px = side;
    EXPECT_THROW(lay_out(figure, font()), FigureError);
  }
}

TEST(Layout, DatesNeitherOverlapNorLeaveThePicture) {
  for (const double days : {0.3, 1.0, 3.0, 20.0, 80.0, 400.0, 1200.0, 9000.0}) {
    for (const int width : {700, 1600}) {
      Figure figure;
      figure.id = "dates";
      figure.title = "Dates";
      figure.width_px = width;
      Panel panel;
      panel.x.title = "measured on";
      panel.x.dates = true;
      panel.y.title = "y";
      panel.series.push_back({"", {20454, 20454 + days / 3, 20454 + days}, {1, 3, 2}});
      figure.panels = {panel};
      const DrawList list = lay_out(figure, font());
      expect_nothing_overlaps(list, std::to_string(days));
      expect_nothing_is_clipped(list, std::to_string(days));
      std::size_t dates = 0;
      for (const Placed& one : texts(list)) {
        if (one.text.rfind("20", 0) == 0) ++dates;
      }
      EXPECT_GE(dates, 1U) << days << " days, " << width;
    }
  }
}

}  // namespace
}  // namespace tribolog::render
