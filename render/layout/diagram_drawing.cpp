#include "render/layout/diagram_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace tribolog::render::layout {
namespace {

constexpr double designed_px_per_mm = 10.0;
constexpr double head_length_mm = 2.6;
constexpr double head_half_width_share = 0.385;  // of the length
constexpr double text_gap_mm = 1.0;
constexpr double capital_height = 0.73;  // of an em

std::vector<double> dashes_of(figure::LineStyle style, double width) {
  const double dash = 4.0 * width;
  const double gap = 2.6 * width;
  switch (style) {
    case figure::LineStyle::dash:
      return {dash, gap};
    case figure::LineStyle::dot:
      return {width, gap};
    case figure::LineStyle::dash_dot:
      return {dash, gap, width, gap};
    case figure::LineStyle::dash_dot_dot:
      return {dash, gap, width, gap, width, gap};
    default:
      return {};
  }
}

}  // namespace

DiagramCanvas::DiagramCanvas(figure::DrawList& list, const figure::Diagram& diagram,
                             const figure::PixelBox& room, const text::Font& font,
                             double most_px_per_mm)
    : list_(list),
      font_(font),
      px_per_mm_(std::min({room.width() / std::max(1.0, diagram.width),
                           room.height() / std::max(1.0, diagram.height), most_px_per_mm})) {
  const double width = px_per_mm_ * diagram.width;
  const double height = px_per_mm_ * diagram.height;
  const figure::PixelPoint middle = room.centre();
  area_ = {middle.x - width / 2, middle.y - height / 2, middle.x + width / 2,
           middle.y + height / 2};
}

figure::PixelPoint DiagramCanvas::pixel(figure::DiagramPoint p) const {
  return {area_.left + px_per_mm_ * p.x, area_.top + px_per_mm_ * p.y};
}

std::vector<figure::PixelPoint> DiagramCanvas::pixels(
    const std::vector<figure::DiagramPoint>& points) const {
  std::vector<figure::PixelPoint> out;
  for (const figure::DiagramPoint& p : points) out.push_back(pixel(p));
  return out;
}

figure::PixelBox DiagramCanvas::box(figure::DiagramPoint centre, double width,
                                    double height) const {
  const figure::PixelPoint c = pixel(centre);
  return {c.x - length(width) / 2, c.y - length(height) / 2, c.x + length(width) / 2,
          c.y + length(height) / 2};
}

double DiagramCanvas::line_width(double designed_px) const {
  return std::max(1.0, designed_px * px_per_mm_ / designed_px_per_mm);
}

void DiagramCanvas::line(figure::Owner owner, std::vector<figure::PixelPoint> points,
                         double designed_px, figure::Colour colour, figure::LineStyle style) {
  const double width = line_width(designed_px);
  list_.primitives.emplace_back(
      figure::Polyline{owner, std::move(points), width, colour, dashes_of(style, width)});
}

void DiagramCanvas::filled(figure::Owner owner, std::vector<figure::PixelPoint> outline,
                           figure::Colour colour) {
  list_.primitives.emplace_back(figure::Polygon{owner, std::move(outline), colour});
}

double DiagramCanvas::head_length(double designed_px) const {
  return length(head_length_mm) * std::max(1.0, std::sqrt(designed_px / diagram_line_px));
}

void DiagramCanvas::head(figure::Owner owner, figure::PixelPoint behind, figure::PixelPoint& tip,
                         double designed_px, figure::Colour colour) {
  const double norm = std::hypot(tip.x - behind.x, tip.y - behind.y);
  if (norm < 1e-6) return;
  const figure::PixelPoint along{(tip.x - behind.x) / norm, (tip.y - behind.y) / norm};
  const double size = head_length(designed_px);
  const double half = head_half_width_share * size;
  const figure::PixelPoint base{tip.x - along.x * size, tip.y - along.y * size};
  filled(owner,
         {tip,
          {base.x - along.y * half, base.y + along.x * half},
          {base.x + along.y * half, base.y - along.x * half}},
         colour);
  tip = {tip.x - along.x * 0.7 * size, tip.y - along.y * 0.7 * size};
}

text::TextLine DiagramCanvas::shape(const std::string& text, double size_mm, bool bold,
                                    figure::Colour colour) {
  text::TextStyle style;
  style.size_px = std::max(8, static_cast<int>(std::lround(length(size_mm))));
  style.weight = bold ? text::Weight::bold : text::Weight::regular;
  style.colour = colour == figure::palette::black ? ink::text : colour;
  return text::shape_line(font_, text, style, faults_);
}

void DiagramCanvas::text(figure::Owner owner, const text::TextLine& line, figure::PixelPoint at,
                         figure::TextPlace place, const std::string& markup, int block) {
  if (line.empty()) return;
  const double gap = length(text_gap_mm);
  figure::PixelPoint start{at.x - line.width / 2, at.y + capital_height * line.style.size_px / 2};
  switch (place) {
    case figure::TextPlace::centre:
      break;
    case figure::TextPlace::left:
      start.x = at.x - gap - line.width;
      break;
    case figure::TextPlace::right:
      start.x = at.x + gap;
      break;
    case figure::TextPlace::above:
      start.y = at.y - gap - line.descent;
      break;
    case figure::TextPlace::below:
      start.y = at.y + gap + line.ascent;
      break;
  }
  texts_.push_back({markup, text::place_line(list_, line, start, true, owner), block});
}

// Wires and the free shapes of a sketch.

namespace {

constexpr double branch_dot_radius_mm = 0.65;
constexpr double step_deg = 4.0;
constexpr double dimension_line_px = 2.0;
constexpr double beside_heads_mm = 0.6;

/// A line with heads at its ends; the line stops inside them.
void draw_arrowed(DiagramCanvas& canvas, figure::Role line_role, figure::Role head_role, int index,
                  std::vector<figure::PixelPoint> points, double width, figure::Colour colour,
                  figure::LineStyle style, bool at_start, bool at_end) {
  if (points.size() < 2) return;
  const std::size_t last = points.size() - 1;
  if (at_start) canvas.head({head_role, 0, index}, points[1], points[0], width, colour);
  if (at_end) canvas.head({head_role, 0, index}, points[last - 1], points[last], width, colour);
  canvas.line({line_role, 0, index}, std::move(points), width, colour, style);
}

/// The head is aligned with the chord that it covers.
void draw_arc(DiagramCanvas& canvas, const figure::Arc& arc, int index) {
  const figure::Owner owner{figure::Role::shape, 0, index};
  figure::Arc line = arc;
  std::vector<figure::PixelPoint> points = arc_points(canvas, arc);
  if (arc.arrow_at_end) {
    const double covered_deg =
        canvas.head_length(arc.width_px) / canvas.length(arc.radius) * 180.0 / std::numbers::pi;
    line.to_deg += arc.to_deg > arc.from_deg ? -covered_deg : covered_deg;
    figure::PixelPoint tip = points.back();
    points = arc_points(canvas, line);
    canvas.head(owner, points.back(), tip, arc.width_px, arc.colour);
    points.push_back(tip);
  } else if (std::abs(arc.to_deg - arc.from_deg) >= 360.0) {
    points.push_back(points[1]);  // joins the closing corner like the others
  }
  canvas.line(owner, std::move(points), arc.width_px, arc.colour);
}

}  // namespace

std::vector<figure::PixelPoint> arc_points(const DiagramCanvas& canvas, const figure::Arc& arc) {
  const figure::PixelPoint c = canvas.pixel(arc.centre);
  const double radius = canvas.length(arc.radius);
  const double sweep = arc.to_deg - arc.from_deg;
  const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / step_deg)));
  std::vector<figure::PixelPoint> out;
  for (int i = 0; i <= steps; ++i) {
    const double angle = (arc.from_deg + sweep * i / steps) * std::numbers::pi / 180.0;
    out.push_back({c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)});
  }
  return out;
}

void draw_wire(DiagramCanvas& canvas, const figure::Wire& wire, int index) {
  draw_arrowed(canvas, figure::Role::wire, figure::Role::wire_head, index,
               canvas.pixels(wire.points), diagram_line_px, wire.colour, figure::LineStyle::solid,
               false, wire.arrow);
  for (const figure::DiagramPoint& dot : wire.branch_dots) {
    figure::Arc circle;
    circle.centre = dot;
    circle.radius = branch_dot_radius_mm;
    canvas.filled({figure::Role::branch_dot, 0, index}, arc_points(canvas, circle), wire.colour);
  }
}

void draw_shape_fills(DiagramCanvas& canvas, const figure::Diagram& diagram) {
  int index = 0;
  for (const figure::Area& area : diagram.areas) {
    canvas.filled({figure::Role::shape_fill, 0, index++}, canvas.pixels(area.outline), area.colour);
  }
  for (const figure::Arc& arc : diagram.arcs) {
    if (!arc.fill) continue;
    figure::Arc whole = arc;
    whole.from_deg = 0;
    whole.to_deg = 360;
    canvas.filled({figure::Role::shape_fill, 0, index++}, arc_points(canvas, whole), *arc.fill);
  }
}

void draw_shapes(DiagramCanvas& canvas, const figure::Diagram& diagram) {
  int index = 0;
  for (const figure::Stroke& one : diagram.strokes) {
    draw_arrowed(canvas, figure::Role::shape, figure::Role::shape, index++,
                 canvas.pixels(one.points), one.width_px, one.colour, one.style, one.arrow_at_start,
                 one.arrow_at_end);
  }
  for (const figure::Arc& arc : diagram.arcs) draw_arc(canvas, arc, index++);
  for (const figure::Dimension& one : diagram.dimensions) {
    draw_arrowed(canvas, figure::Role::shape, figure::Role::shape, index++,
                 canvas.pixels({one.from, one.to}), dimension_line_px, one.colour,
                 figure::LineStyle::solid, true, true);
  }
}

void draw_diagram_texts(DiagramCanvas& canvas, const figure::Diagram& diagram) {
  int index = 0;
  const auto draw = [&](const figure::DiagramText& one) {
    const text::TextLine line = canvas.shape(one.text, letter::label_mm, one.bold, one.colour);
    canvas.text({figure::Role::shape_text, 0, index++}, line, canvas.pixel(one.at), one.place,
                one.text, -1);
  };
  for (const figure::Wire& wire : diagram.wires) {
    if (wire.label) draw(*wire.label);
  }
  for (const figure::Dimension& one : diagram.dimensions) {
    figure::DiagramPoint middle{(one.from.x + one.to.x) / 2, (one.from.y + one.to.y) / 2};
    if (one.place == figure::TextPlace::above) middle.y -= beside_heads_mm;
    if (one.place == figure::TextPlace::below) middle.y += beside_heads_mm;
    draw({one.text, middle, one.place, false, one.colour});
  }
  for (const figure::DiagramText& one : diagram.texts) draw(one);
}

}  // namespace tribolog::render::layout
