#include "render/vtk/strip_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/figure/draw_list.h"

namespace tribolog::render::vtk {
namespace {

constexpr double flatness = 0.2;  // pixels between a round join and its polygon

figure::PixelPoint direction(figure::PixelPoint from, figure::PixelPoint to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

/// As many as a circle needs to be round within the flatness.
int circle_corners(double radius) {
  constexpr int fewest = 8;
  if (radius <= flatness) return fewest;
  return std::max(
      fewest, static_cast<int>(std::ceil(std::numbers::pi / std::acos(1.0 - flatness / radius))));
}

std::vector<figure::PixelPoint> marker_outline(figure::Marker shape, figure::PixelPoint c,
                                               double radius) {
  if (shape != figure::Marker::circle) return figure::marker_corners(shape, c, radius);
  return figure::regular_polygon(c, radius, circle_corners(radius), 0.0);
}

}  // namespace

void StripBuilder::pair(figure::PixelPoint a, figure::PixelPoint b) {
  points_.push_back(a);
  points_.push_back(b);
}

void StripBuilder::begin_part(figure::PixelPoint at) {
  if (!points_.empty()) pair(at, at);
}

void StripBuilder::end_part(figure::PixelPoint at) { pair(at, at); }

void StripBuilder::stroke(const std::vector<figure::PixelPoint>& line, double width) {
  const double half = width / 2;
  const double widest_turn = 2.0 * std::acos(std::max(0.0, 1.0 - flatness / half));
  const auto across = [&](figure::PixelPoint p, double angle) {
    const figure::PixelPoint normal{-std::sin(angle) * half, std::cos(angle) * half};
    pair({p.x + normal.x, p.y + normal.y}, {p.x - normal.x, p.y - normal.y});
  };
  double angle = 0;
  bool started = false;
  figure::PixelPoint end = line.front();
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == end) continue;
    const figure::PixelPoint along = direction(end, line[i]);
    const double next = std::atan2(along.y, along.x);
    if (!started) {
      begin_part(end);
      across(end, next);
      started = true;
    } else {
      const double turn = std::remainder(next - angle, 2.0 * std::numbers::pi);
      const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / widest_turn)));
      for (int k = 1; k <= steps; ++k) across(end, angle + turn * k / steps);
    }
    across(line[i], next);
    angle = next;
    end = line[i];
  }
  if (started) end_part(end);
}

void StripBuilder::convex(const std::vector<figure::PixelPoint>& outline) {
  if (outline.size() < 3) return;
  begin_part(outline.front());
  pair(outline.front(), outline.front());
  std::size_t up = 1;
  std::size_t down = outline.size() - 1;
  for (; up < down; ++up, --down) pair(outline[up], outline[down]);
  if (up == down) pair(outline[up], outline[up]);
  end_part(points_.back());
}

void StripBuilder::add(const figure::Polyline& line) {
  if (line.points.size() < 2) return;
  for (const auto& dash : figure::cut_into_dashes(line.points, line.dashes)) {
    if (dash.size() > 1) stroke(dash, line.width);
  }
}

void StripBuilder::add(const figure::Ribbon& ribbon) {
  if (ribbon.edge_a.size() < 2) return;
  begin_part(ribbon.edge_a.front());
  for (std::size_t i = 0; i < ribbon.edge_a.size(); ++i) pair(ribbon.edge_a[i], ribbon.edge_b[i]);
  end_part(ribbon.edge_b.back());
}

void StripBuilder::add(const figure::Polygon& polygon) { convex(polygon.outline); }

void StripBuilder::add(const figure::Markers& markers, double grow) {
  const double radius = figure::marker_radius(markers, grow);
  const double reach_of_any_shape =
      1.5 * radius + figure::marker_strokes(markers, {}, grow).thickness;
  for (const figure::PixelPoint& c : markers.centres) {
    if (c.y + reach_of_any_shape < top_ || c.y - reach_of_any_shape > bottom_) continue;
    if (figure::is_stroked(markers.shape)) {
      const figure::MarkerStrokes strokes = figure::marker_strokes(markers, c, grow);
      for (const auto& [from, to] : strokes.lines) stroke({from, to}, strokes.thickness);
    } else if (markers.shape != figure::Marker::none) {
      convex(marker_outline(markers.shape, c, radius));
    }
  }
}

}  // namespace tribolog::render::vtk
