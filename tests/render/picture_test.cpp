#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "render/composition/figure_layout.h"
#include "render/example_figures.h"
#include "render/png_reading.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::render::picture_test {
namespace {

workers::DrawnFigure drawn(const figure::Figure& figure) {
  return workers::FigureRenderer(1).draw({figure}).at(0);
}

/// Where a data point lies in the picture.
figure::PixelPoint pixel_of(const figure::DrawList& list, const figure::Axis& x_axis,
                            const figure::Axis& y_axis, double x, double y) {
  const figure::PixelBox plot = list.plots.at(0);
  return {
      plot.left + (x - *x_axis.minimum) / (*x_axis.maximum - *x_axis.minimum) * plot.width(),
      plot.bottom - (y - *y_axis.minimum) / (*y_axis.maximum - *y_axis.minimum) * plot.height()};
}

figure::Figure with_fixed_axes() {
  figure::Figure figure = examples::plain();
  figure.panels[0].series = {examples::line({0, 10}, {2, 2}, "level"),
                             examples::line({0, 10}, {0, 10}, "rising")};
  figure.panels[0].series[1].colour = figure::palette::vermilion;
  for (figure::Series& one : figure.panels[0].series) one.width_px = 4;
  figure.panels[0].x.minimum = figure.panels[0].y.minimum = 0;
  figure.panels[0].x.maximum = figure.panels[0].y.maximum = 10;
  return figure;
}

TEST(Picture, ShowsSeriesWhereTheyBelong) {
  const figure::Figure figure = with_fixed_axes();
  const workers::DrawnFigure result = drawn(figure);
  ASSERT_EQ(wording::words(result.error), "");
  const figure::Picture picture = read_png(result.png);
  const text::Font font;
  const figure::DrawList list = composition::lay_out(figure, font);
  const figure::Panel& panel = figure.panels[0];
  const auto colour_at = [&](double x, double y) {
    const figure::PixelPoint p = pixel_of(list, panel.x, panel.y, x, y);
    return picture.at(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y)));
  };
  for (const double x : {1.0, 4.3, 7.7, 9.0}) {
    EXPECT_EQ(colour_at(x, 2), figure::palette::blue) << x;
    EXPECT_EQ(colour_at(x, x), figure::palette::vermilion) << x;
  }
  EXPECT_EQ(colour_at(7.3, 4.7), (figure::Colour{255, 255, 255}));
}

TEST(Picture, HasInkOfEveryTextInsideItsBoxAndNoneBeside) {
  figure::Figure figure = examples::stacked();
  figure.title = "Tgjpq q\u0307 φ\u0307_{f} x^{2}";
  const workers::DrawnFigure result = drawn(figure);
  ASSERT_EQ(wording::words(result.error), "");
  const figure::Picture picture = read_png(result.png);
  const text::Font font;
  const figure::DrawList list = composition::lay_out(figure, font);
  const auto ink_in = [&](const figure::PixelBox& box) {
    int count = 0;
    for (int y = static_cast<int>(box.top); y < static_cast<int>(box.bottom); ++y) {
      for (int x = static_cast<int>(box.left); x < static_cast<int>(box.right); ++x) {
        count += picture.at(x, y).red < 128 ? 1 : 0;
      }
    }
    return count;
  };
  // The title stands alone: all dark pixels of the top strip belong to its boxes.
  int inside = 0;
  figure::PixelBox hull{1e9, 1e9, -1e9, -1e9};
  for (const figure::Primitive& one : list.primitives) {
    const auto* run = std::get_if<figure::TextRun>(&one);
    if (run == nullptr || run->owner.role != figure::Role::figure_title) continue;
    EXPECT_GT(ink_in(run->box.grown(1)), 0) << run->text;
    hull = {std::min(hull.left, run->box.left), std::min(hull.top, run->box.top),
            std::max(hull.right, run->box.right), std::max(hull.bottom, run->box.bottom)};
  }
  inside = ink_in(hull.grown(2));
  EXPECT_GT(inside, 100);
  EXPECT_EQ(ink_in({0, 0, static_cast<double>(list.width), std::ceil(hull.bottom) + 3}), inside);
}

TEST(Picture, DrawsEveryNastyFigure) {
  const std::vector<figure::Figure> all = examples::nasty();
  const auto results = workers::FigureRenderer().draw(all);
  ASSERT_EQ(results.size(), all.size());
  for (const workers::DrawnFigure& one : results) {
    EXPECT_EQ(wording::words(one.error), "") << one.id;
    EXPECT_FALSE(one.png.empty()) << one.id;
  }
}

TEST(Picture, ReportsASeriesThatNobodyCanSee) {
  figure::Figure figure = with_fixed_axes();
  figure.panels[0].series[1].colour = {255, 255, 255};
  EXPECT_EQ(wording::words(drawn(figure).error),
            "series 'rising' cannot be told from the background");
  figure.panels[0].series[1].colour = {0, 0, 0, 0};
  EXPECT_FALSE(drawn(figure).error.empty());
}

TEST(Picture, OnlyWarnsOfASeriesUnderAnotherOrOutside) {
  figure::Figure figure = with_fixed_axes();
  figure.panels[0].series[1] = figure.panels[0].series[0];
  figure.panels[0].series[1].colour = figure::palette::black;
  workers::DrawnFigure result = drawn(figure);
  EXPECT_EQ(wording::words(result.error), "");
  EXPECT_EQ(result.warnings.size(), 1U);

  figure.panels[0].series[1].y = {50, 50};
  result = drawn(figure);
  EXPECT_EQ(wording::words(result.error), "");
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_TRUE(result.warnings[0].is("drawing.outside_axes")) << wording::words(result.warnings[0]);
}

TEST(Picture, ShowsTwoMillionPoints) {
  figure::Figure figure = examples::plain();
  figure::Series& series = figure.panels[0].series[0];
  series.x.clear();
  series.y.clear();
  for (int i = 0; i < 2'000'000; ++i) {
    series.x.push_back(i * 1e-4);
    series.y.push_back(std::sin(i * 1e-4) + 0.1 * std::sin(i * 12.9898));
  }
  EXPECT_EQ(wording::words(drawn(figure).error), "");
}

}  // namespace
}  // namespace tribolog::render::picture_test
