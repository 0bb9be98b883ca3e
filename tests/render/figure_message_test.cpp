#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "render/example_diagram.h"
#include "render/example_figures.h"
#include "render/workers/messages.h"

namespace tribolog::render::figure_message_test {
namespace {

std::vector<std::byte> bytes_of(const figure::Figure& figure) {
  workers::Message message;
  workers::put_figure(message, figure);
  return message.bytes();
}

figure::Figure through_a_message(const figure::Figure& figure) {
  workers::Message message;
  workers::put_figure(message, figure);
  return workers::take_figure(message);
}

/// That a changed field changes the message, and comes out of it again.
template <class Field, class Value>
void expect_written(const figure::Figure& figure, Field& field, const Value& value) {
  const std::vector<std::byte> before = bytes_of(figure);
  const Field old = field;
  field = value;
  EXPECT_NE(bytes_of(figure), before);
  EXPECT_EQ(bytes_of(through_a_message(figure)), bytes_of(figure));
  field = old;
}

TEST(FigureMessage, KeepsEveryField) {
  std::vector<figure::Figure> figures = examples::nasty();
  for (const figure::Figure& figure :
       {examples::plain(), examples::hysteresis(), examples::stacked(), examples::many_curves(10),
        examples::noisy_sweep(), examples::diagram(), examples::scene(), examples::scene(30)}) {
    figures.push_back(figure);
  }
  for (const figure::Figure& figure : figures) {
    EXPECT_EQ(bytes_of(through_a_message(figure)), bytes_of(figure)) << figure.id;
  }
}

// The comparison above sees only what is written; each field is therefore changed once.
TEST(FigureMessage, WritesEveryField) {
  figure::Figure figure;
  figure.panels.resize(1);
  figure::Panel& panel = figure.panels[0];
  panel.bands.resize(1);
  panel.series.resize(1);
  panel.error_bars.resize(1);
  panel.point_labels.resize(1);
  panel.reference_lines.resize(1);
  const auto expect_change = [&](auto& field, auto value) { expect_written(figure, field, value); };
  const std::vector<double> numbers{1.5, std::numeric_limits<double>::infinity()};
  const figure::Colour colour{1, 2, 3, 4};
  expect_change(figure.id, "id");
  expect_change(figure.title, "title");
  expect_change(figure.width_px, 7);
  expect_change(figure.height_px, 7);
  expect_change(figure.panels_share_x, true);
  expect_change(figure.width_mm, 84.0);
  expect_change(figure.look, figure::Look::publication);
  expect_change(panel.title, "title");
  expect_change(panel.show_legend, false);
  expect_change(panel.labels_at_ends, true);
  expect_change(panel.notice, "nothing");
  for (figure::Axis* axis : {&panel.x, &panel.y}) {
    expect_change(axis->title, "q [rad]");
    expect_change(axis->minimum, std::optional(1.0));
    expect_change(axis->maximum, std::optional(1.0));
    expect_change(axis->logarithmic, true);
    expect_change(axis->dates, true);
    expect_change(axis->counts, true);
    expect_change(axis->linear_within, 0.5);
    expect_change(axis->names, std::vector<figure::AxisName>{{1.5, "mid-line"}});
  }
  figure::Band& band = panel.bands[0];
  expect_change(band.label, "band");
  expect_change(band.x, numbers);
  expect_change(band.low, numbers);
  expect_change(band.high, numbers);
  expect_change(band.colour, colour);
  figure::Series& series = panel.series[0];
  expect_change(series.label, "series");
  expect_change(series.x, numbers);
  expect_change(series.y, numbers);
  expect_change(series.colour, colour);
  expect_change(series.width_px, 7.0);
  expect_change(series.style, figure::LineStyle::dot);
  expect_change(series.marker, figure::Marker::plus);
  expect_change(series.marker_size_px, 7.0);
  expect_change(series.direction_arrows_at, numbers);
  expect_change(series.is_marked_at_edge, true);
  figure::ErrorBar& bar = panel.error_bars[0];
  expect_change(bar.x, 7.0);
  expect_change(bar.low, 7.0);
  expect_change(bar.high, 7.0);
  expect_change(bar.colour, colour);
  figure::PointLabel& label = panel.point_labels[0];
  expect_change(label.x, 7.0);
  expect_change(label.y, 7.0);
  expect_change(label.text, "A");
  expect_change(label.colour, colour);
  expect_change(label.marker, figure::Marker::plus);
  figure::ReferenceLine& line = panel.reference_lines[0];
  expect_change(line.direction, figure::ReferenceLine::Direction::horizontal);
  expect_change(line.at, 7.0);
  expect_change(line.text, "q_{c}");
  expect_change(line.colour, colour);
  expect_change(line.style, figure::LineStyle::dot);
}

TEST(FigureMessage, WritesEveryFieldOfADiagram) {
  figure::Figure figure;
  expect_written(figure, figure.diagram, std::optional(figure::Diagram{}));
  figure::Diagram& diagram = figure.diagram.emplace();
  diagram.areas.resize(1);
  diagram.blocks.resize(1);
  diagram.blocks[0].signs.resize(1);
  diagram.wires.resize(1);
  diagram.wires[0].label.emplace();
  diagram.strokes.resize(1);
  diagram.arcs.resize(1);
  diagram.dimensions.resize(1);
  diagram.texts.resize(1);
  const auto expect_change = [&](auto& field, auto value) { expect_written(figure, field, value); };
  const std::vector<figure::DiagramPoint> points{{1, 2}, {3, 4}};
  const figure::DiagramPoint point{5, 6};
  const figure::Colour colour{1, 2, 3, 4};
  expect_change(diagram.width, 7.0);
  expect_change(diagram.height, 7.0);
  expect_change(diagram.areas[0].outline, points);
  expect_change(diagram.areas[0].colour, colour);
  figure::Block& block = diagram.blocks[0];
  expect_change(block.kind, figure::BlockKind::frame);
  expect_change(block.lines, std::vector<std::string>{"g(ω)", "x"});
  expect_change(block.centre, point);
  expect_change(block.width, 7.0);
  expect_change(block.height, 7.0);
  expect_change(block.faces, figure::BlockSide::top);
  expect_change(block.signs[0].side, figure::BlockSide::top);
  expect_change(block.signs[0].offset, 7.0);
  expect_change(block.signs[0].text, "+");
  expect_change(block.colour, colour);
  expect_change(block.fill, colour);
  figure::Wire& wire = diagram.wires[0];
  expect_change(wire.points, points);
  expect_change(wire.arrow, false);
  expect_change(wire.branch_dots, points);
  expect_change(wire.label, std::optional<figure::DiagramText>());
  expect_change(wire.colour, colour);
  figure::Stroke& stroke = diagram.strokes[0];
  expect_change(stroke.points, points);
  expect_change(stroke.colour, colour);
  expect_change(stroke.width_px, 7.0);
  expect_change(stroke.style, figure::LineStyle::dot);
  expect_change(stroke.arrow_at_start, true);
  expect_change(stroke.arrow_at_end, true);
  figure::Arc& arc = diagram.arcs[0];
  expect_change(arc.centre, point);
  expect_change(arc.radius, 7.0);
  expect_change(arc.from_deg, 7.0);
  expect_change(arc.to_deg, 7.0);
  expect_change(arc.colour, colour);
  expect_change(arc.width_px, 7.0);
  expect_change(arc.arrow_at_end, true);
  expect_change(arc.fill, std::optional(colour));
  figure::Dimension& dimension = diagram.dimensions[0];
  expect_change(dimension.from, point);
  expect_change(dimension.to, point);
  expect_change(dimension.text, "z");
  expect_change(dimension.place, figure::TextPlace::left);
  expect_change(dimension.colour, colour);
  figure::DiagramText& text = diagram.texts[0];
  expect_change(text.text, "z");
  expect_change(text.at, point);
  expect_change(text.place, figure::TextPlace::left);
  expect_change(text.bold, true);
  expect_change(text.colour, colour);
}

TEST(FigureMessage, WritesEveryFieldOfAScene) {
  figure::Figure figure;
  expect_written(figure, figure.scene, std::optional(figure::Scene{}));
  figure::Scene& scene = figure.scene.emplace();
  const auto expect_change = [&](auto& field, auto value) { expect_written(figure, field, value); };
  const auto expect_points = [&](auto&... points) {
    const auto one = [&](figure::Point3& point) {
      for (double* part : {&point.x, &point.y, &point.z}) expect_change(*part, 7.0);
    };
    (one(points), ...);
  };
  const figure::Colour colour{1, 2, 3, 4};
  const auto expect_named = [&](auto& part) {
    expect_change(part.label, "r_{3}");
    expect_change(part.colour, colour);
  };
  expect_change(scene.ground, std::optional(figure::SceneGround{}));
  scene.ground.emplace();
  expect_points(scene.ground->centre, scene.camera.towards, scene.camera.up);
  expect_change(scene.ground->half_size_m, 7.0);
  expect_change(scene.ground->spacing_m, 7.0);
  expect_change(scene.camera.opening_deg, 7.0);
  expect_change(scene.camera.margin, 7.0);
  expect_change(scene.camera.fit, std::vector<figure::Point3>(2));
  figure::SceneBody& body = scene.bodies.emplace_back();
  expect_named(body);
  expect_points(body.from, body.to, body.normal);
  for (double* size : {&body.from_radius_m, &body.to_radius_m, &body.thickness_m}) {
    expect_change(*size, 7.0);
  }
  figure::SceneDrum& drum = scene.drums.emplace_back();
  expect_named(drum);
  expect_points(drum.centre, drum.axis);
  expect_change(drum.radius_m, 7.0);
  expect_change(drum.length_m, 7.0);
  figure::SceneArrow& arrow = scene.arrows.emplace_back();
  expect_named(arrow);
  expect_points(arrow.from, arrow.to);
  expect_change(arrow.radius_m, 7.0);
  figure::SceneBall& ball = scene.balls.emplace_back();
  expect_named(ball);
  expect_points(ball.centre);
  expect_change(ball.radius_m, 7.0);
  expect_change(ball.inside, true);
  figure::SceneSector& sector = scene.sectors.emplace_back();
  expect_named(sector);
  expect_points(sector.centre, sector.normal, sector.zero);
  for (double* size : {&sector.radius_m, &sector.from_rad, &sector.to_rad}) {
    expect_change(*size, 7.0);
  }
  expect_change(sector.filled, true);
  expect_change(sector.fill, colour);
  expect_change(sector.ends, figure::ArcEnds::arrow_at_both);
  figure::SceneDimension& dimension = scene.dimensions.emplace_back();
  expect_named(dimension);
  expect_points(dimension.from, dimension.to, dimension.shift);
  figure::SceneLine& line = scene.lines.emplace_back();
  expect_named(line);
  expect_change(line.points, std::vector<figure::Point3>(2));
  expect_change(line.width_px, 7.0);
  expect_change(line.style, figure::LineStyle::dot);
  figure::SceneText& text = scene.texts.emplace_back();
  expect_change(text.text, "q_{c}");
  expect_points(text.at);
  expect_change(text.colour, colour);
}

TEST(FigureMessage, RefusesOneThatEndsEarly) {
  workers::Message message;
  workers::put_figure(message, examples::plain());
  message.bytes().resize(message.bytes().size() / 2);
  EXPECT_THROW(workers::take_figure(message), std::runtime_error);
}

}  // namespace
}  // namespace tribolog::render::figure_message_test
