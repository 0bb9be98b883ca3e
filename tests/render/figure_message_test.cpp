#include "render/workers/figure_message.h"

#include <limits>

#include <gtest/gtest.h>

#include "example_figures.h"

namespace tribolog::render {
namespace {

std::vector<std::byte> bytes_of(const Figure& figure) {
  Message message;
  put_figure(message, figure);
  return message.bytes();
}

Figure through_a_message(const Figure& figure) {
  Message message;
  put_figure(message, figure);
  return take_figure(message);
}

TEST(FigureMessage, KeepsEveryField) {
  std::vector<Figure> figures = examples::nasty();
  for (const Figure& figure : {examples::plain(), examples::hysteresis(), examples::stacked(),
                               examples::many_curves(10), examples::noisy_sweep()}) {
    figures.push_back(figure);
  }
  for (const Figure& figure : figures) {
    EXPECT_EQ(bytes_of(through_a_message(figure)), bytes_of(figure)) << figure.id;
  }
}

// The comparison above sees only what is written; each field is therefore changed once.
TEST(FigureMessage, WritesEveryField) {
  Figure figure;
  figure.panels.resize(1);
  Panel& panel = figure.panels[0];
  panel.bands.resize(1);
  panel.series.resize(1);
  panel.error_bars.resize(1);
  panel.point_labels.resize(1);
  panel.reference_lines.resize(1);
  const std::vector<std::byte> before = bytes_of(figure);
  const auto expect_change = [&](auto& field, auto value) {
    const auto old = field;
    field = value;
    EXPECT_NE(bytes_of(figure), before);
    EXPECT_EQ(bytes_of(through_a_message(figure)), bytes_of(figure));
    field = old;
  };
  const std::vector<double> numbers{1.5, std::numeric_limits<double>::infinity()};
  const Colour colour{1, 2, 3, 4};
  expect_change(figure.id, "id");
  expect_change(figure.title, "title");
  expect_change(figure.width_px, 7);
  expect_change(figure.height_px, 7);
  expect_change(figure.panels_share_x, true);
  expect_change(panel.title, "title");
  expect_change(panel.show_legend, false);
  for (Axis* axis : {&panel.x, &panel.y}) {
    expect_change(axis->title, "q [rad]");
    expect_change(axis->minimum, std::optional(1.0));
    expect_change(axis->maximum, std::optional(1.0));
    expect_change(axis->logarithmic, true);
  }
  Band& band = panel.bands[0];
  expect_change(band.label, "band");
  expect_change(band.x, numbers);
  expect_change(band.low, numbers);
  expect_change(band.high, numbers);
  expect_change(band.colour, colour);
  Series& series = panel.series[0];
  expect_change(series.label, "series");
  expect_change(series.x, numbers);
  expect_change(series.y, numbers);
  expect_change(series.colour, colour);
  expect_change(series.width_px, 7.0);
  expect_change(series.style, LineStyle::dot);
  expect_change(series.marker, Marker::plus);
  expect_change(series.marker_size_px, 7.0);
  expect_change(series.direction_arrows_at, numbers);
  ErrorBar& bar = panel.error_bars[0];
  expect_change(bar.x, 7.0);
  expect_change(bar.low, 7.0);
  expect_change(bar.high, 7.0);
  expect_change(bar.colour, colour);
  PointLabel& label = panel.point_labels[0];
  expect_change(label.x, 7.0);
  expect_change(label.y, 7.0);
  expect_change(label.text, "A");
  expect_change(label.colour, colour);
  expect_change(label.marker, Marker::plus);
  ReferenceLine& line = panel.reference_lines[0];
  expect_change(line.direction, ReferenceLine::Direction::horizontal);
  expect_change(line.at, 7.0);
  expect_change(line.text, "q_{c}");
  expect_change(line.colour, colour);
  expect_change(line.style, LineStyle::dot);
}

TEST(FigureMessage, RefusesOneThatEndsEarly) {
  Message message;
  put_figure(message, examples::plain());
  message.bytes().resize(message.bytes().size() / 2);
  EXPECT_THROW(take_figure(message), std::runtime_error);
}

}  // namespace
}  // namespace tribolog::render
