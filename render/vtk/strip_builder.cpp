#include "render/vtk/strip_builder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "render/figure/draw_list.h"

namespace tribolog::render::vtk {
namespace {

constexpr double flatness = 0.2;  // pixels between a round join and its polygon
constexpr double fade = 0.5;      // pixels on either side of an edge over which the colour goes

double distance(figure::PixelPoint a, figure::PixelPoint b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

figure::PixelPoint direction(figure::PixelPoint from, figure::PixelPoint to) {
  const double length = distance(from, to);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

figure::PixelPoint moved(figure::PixelPoint p, figure::PixelPoint along, double by) {
  return {p.x + by * along.x, p.y + by * along.y};
}

figure::PixelPoint opposite(figure::PixelPoint along) { return {-along.x, -along.y}; }

/// To its left, seen along it on the screen.
figure::PixelPoint normal(figure::PixelPoint along) { return {-along.y, along.x}; }

/// At each point of an edge the unit vector across it that points away from the other edge.
std::vector<figure::PixelPoint> away_from(const std::vector<figure::PixelPoint>& other,
                                          const std::vector<figure::PixelPoint>& edge) {
  std::vector<figure::PixelPoint> out(edge.size());
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const figure::PixelPoint from = edge[i > 0 ? i - 1 : 0];
    const figure::PixelPoint to = edge[std::min(i + 1, edge.size() - 1)];
    if (from == to) continue;
    out[i] = normal(direction(from, to));
    const double side = (edge[i].x - other[i].x) * out[i].x + (edge[i].y - other[i].y) * out[i].y;
    if (side < 0) out[i] = opposite(out[i]);
  }
  return out;
}

/// Where the corners of a convex outline go when its edges move outwards by one pixel. An obtuse
/// corner goes no further than its edges by much, and an acute one is cut.
std::vector<figure::PixelPoint> corners_outwards(const std::vector<figure::PixelPoint>& outline,
                                                 double turning) {
  constexpr double sharpest = 0.3;  // 1 + the cosine between the normals of two edges
  std::vector<figure::PixelPoint> out(outline.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const figure::PixelPoint before = outline[(i + outline.size() - 1) % outline.size()];
    const figure::PixelPoint behind = outline[(i + 1) % outline.size()];
    const figure::PixelPoint a = normal(direction(before, outline[i]));
    const figure::PixelPoint b = normal(direction(outline[i], behind));
    const double scale = -turning / std::max(sharpest, 1 + a.x * b.x + a.y * b.y);
    out[i] = {scale * (a.x + b.x), scale * (a.y + b.y)};
  }
  return out;
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

void StripBuilder::pair(StripPoint a, StripPoint b) {
  for (StripPoint* const p : {&a, &b}) {
    p->colour = colour_;
    p->colour.alpha = static_cast<std::uint8_t>(std::lround(p->cover * colour_.alpha));
    points_.push_back(*p);
  }
}

void StripBuilder::begin_part(StripPoint at) {
  if (!points_.empty()) pair(at, at);
}

void StripBuilder::end_part(StripPoint at) { pair(at, at); }

// The inside, and both edges, of which the outer half of the fading lies beyond.
void StripBuilder::add(const std::vector<Section>& sections) {
  const auto inside = [](const Section& s, figure::PixelPoint edge, figure::PixelPoint out) {
    const double width = distance(s.left, s.right);
    // A line thinner than a pixel fades from its middle on, and keeps its ink.
    const double most = width < 1 ? 2 * width / (1 + width) : 1;
    return StripPoint{moved(edge, out, -std::min(fade, width / 2)), s.cover * most};
  };
  const auto left = [&](const Section& s) { return inside(s, s.left, s.out_left); };
  const auto right = [&](const Section& s) { return inside(s, s.right, s.out_right); };
  begin_part(left(sections.front()));
  for (const Section& s : sections) pair(left(s), right(s));
  end_part(right(sections.back()));
  begin_part(left(sections.front()));
  for (const Section& s : sections) pair({moved(s.left, s.out_left, fade), 0}, left(s));
  end_part(left(sections.back()));
  begin_part(right(sections.front()));
  for (const Section& s : sections) pair(right(s), {moved(s.right, s.out_right, fade), 0});
  end_part(right(sections.back()));
}

void StripBuilder::stroke(const std::vector<figure::PixelPoint>& line, double width) {
  const double half = width / 2;
  const double widest_turn = 2.0 * std::acos(std::max(0.0, 1.0 - flatness / half));
  std::vector<Section> sections;
  const auto across = [&](figure::PixelPoint p, double angle, double cover = 1) {
    const figure::PixelPoint out{-std::sin(angle), std::cos(angle)};
    sections.push_back({moved(p, out, half), moved(p, out, -half), out, opposite(out), cover});
  };
  double angle = 0;
  double inset = 0;
  figure::PixelPoint along;
  figure::PixelPoint end = line.front();
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == end) continue;
    along = direction(end, line[i]);
    inset = std::min(fade, distance(end, line[i]) / 2);
    const double next = std::atan2(along.y, along.x);
    if (sections.empty()) {
      across(moved(end, along, -fade), next, 0);
      across(moved(end, along, inset), next);
    } else {
      const double turn = std::remainder(next - angle, 2.0 * std::numbers::pi);
      const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / widest_turn)));
      for (int k = 1; k <= steps; ++k) across(end, angle + turn * k / steps);
    }
    across(line[i], next);
    angle = next;
    end = line[i];
  }
  if (sections.empty()) return;
  sections.pop_back();
  across(moved(end, along, -inset), angle);
  across(moved(end, along, fade), angle, 0);
  add(sections);
}

void StripBuilder::convex(const std::vector<figure::PixelPoint>& with_repeats) {
  std::vector<figure::PixelPoint> outline;
  for (const figure::PixelPoint p : with_repeats) {
    if (outline.empty() || (!(p == outline.back()) && !(p == outline.front())))
      outline.push_back(p);
  }
  if (outline.size() < 3) return;
  double twice_the_area = 0;
  double way_round = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const figure::PixelPoint a = outline[i];
    const figure::PixelPoint b = outline[(i + 1) % outline.size()];
    twice_the_area += a.x * b.y - b.x * a.y;
    way_round += distance(a, b);
  }
  const double inset = std::min(fade, std::abs(twice_the_area) / 2 / way_round);
  const std::vector<figure::PixelPoint> out =
      corners_outwards(outline, twice_the_area > 0 ? 1 : -1);
  const auto inner = [&](std::size_t i) {
    return StripPoint{moved(outline[i], out[i], -inset), inset / fade};
  };
  begin_part(inner(0));
  pair(inner(0), inner(0));
  std::size_t up = 1;
  std::size_t down = outline.size() - 1;
  for (; up < down; ++up, --down) pair(inner(up), inner(down));
  if (up == down) pair(inner(up), inner(up));
  end_part(points_.back());
  begin_part(inner(0));
  for (std::size_t k = 0; k <= outline.size(); ++k) {
    const std::size_t i = k % outline.size();
    pair({moved(outline[i], out[i], fade), 0}, inner(i));
  }
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
  const std::vector<figure::PixelPoint> out_a = away_from(ribbon.edge_b, ribbon.edge_a);
  const std::vector<figure::PixelPoint> out_b = away_from(ribbon.edge_a, ribbon.edge_b);
  std::vector<Section> sections;
  for (std::size_t i = 0; i < ribbon.edge_a.size(); ++i) {
    sections.push_back({ribbon.edge_a[i], ribbon.edge_b[i], out_a[i], out_b[i]});
  }
  add(sections);
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
