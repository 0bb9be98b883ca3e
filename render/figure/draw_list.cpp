#include "render/figure/draw_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/figure/scene.h"

namespace tribolog::render::figure {

double SceneView::distance(Point3 p) const { return dot(p - eye, forward); }

PixelPoint SceneView::pixel(Point3 p) const {
  const double k = parallel ? scale : scale / distance(p);
  return {origin.x + k * dot(p - eye, right), origin.y - k * dot(p - eye, up)};
}

double SceneView::metres_per_pixel(Point3 p) const {
  return (parallel ? 1.0 : distance(p)) / scale;
}

Point3 SceneView::moved_to(Point3 p, double distance_m) const {
  if (parallel) return p + (distance_m - distance(p)) * forward;
  return eye + (distance_m / distance(p)) * (p - eye);
}

std::array<double, 16> SceneView::clip_matrix(int width, int top, int rows) const {
  const double kx = 2 * scale / width;
  const double ky = 2 * scale / rows;
  const double dx = 2 * origin.x / width - 1;
  const double dy = 1 - 2 * (origin.y - top) / rows;
  const double n = 0.25 * nearest_m;
  const double f = 1.05 * farthest_m;
  if (parallel) {
    return {kx,
            0,
            0,
            dx,  //
            0,
            ky,
            0,
            dy,  //
            0,
            0,
            -2 / (f - n),
            -(f + n) / (f - n),  //
            0,
            0,
            0,
            1};
  }
  return {kx,
          0,
          -dx,
          0,  //
          0,
          ky,
          -dy,
          0,  //
          0,
          0,
          -(f + n) / (f - n),
          -2 * f * n / (f - n),  //
          0,
          0,
          -1,
          0};
}

// Styles of lines, and markers.

std::vector<double> dash_lengths(LineStyle style, double width) {
  const double unit = std::max(width, 1.5);
  const double dash = 5.0 * unit;
  const double dot = 1.3 * unit;
  const double gap = 2.4 * unit;
  switch (style) {
    case LineStyle::dash:
      return {dash, gap};
    case LineStyle::dot:
      return {dot, 1.6 * unit};
    case LineStyle::dash_dot:
      return {1.4 * dash, gap, dot, gap};
    case LineStyle::dash_dot_dot:
      return {1.4 * dash, gap, dot, gap, dot, gap};
    case LineStyle::none:
    case LineStyle::solid:
      break;
  }
  return {};
}

std::vector<std::vector<PixelPoint>> cut_into_dashes(const std::vector<PixelPoint>& line,
                                                     const std::vector<double>& lengths) {
  if (lengths.empty()) return {line};
  std::vector<std::vector<PixelPoint>> out;
  std::vector<PixelPoint> dash;
  std::size_t phase = 0;
  double remaining = lengths[0];
  if (!line.empty()) dash.push_back(line.front());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PixelPoint from = line[i - 1];
    const PixelPoint to = line[i];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    double done = 0.0;
    while (length - done > remaining) {
      done += remaining;
      const double t = done / length;
      const PixelPoint here{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      dash.push_back(here);
      if (phase % 2 == 0) out.push_back(std::exchange(dash, {}));
      dash.assign(1, here);
      phase = (phase + 1) % lengths.size();
      remaining = lengths[phase];
    }
    remaining -= length - done;
    if (phase % 2 == 0) dash.push_back(to);
  }
  if (phase % 2 == 0 && dash.size() > 1) out.push_back(std::move(dash));
  return out;
}

bool has_rim(const Markers& markers) {
  constexpr double largest_dot_px = 8.0;
  return !is_stroked(markers.shape) && markers.size > largest_dot_px;
}

bool is_stroked(Marker shape) { return shape == Marker::cross || shape == Marker::plus; }

double marker_radius(const Markers& markers, double grow) { return markers.size / 2 + grow; }

MarkerStrokes marker_strokes(const Markers& markers, PixelPoint c, double grow) {
  const double radius = marker_radius(markers, grow);
  const double reach = markers.shape == Marker::cross ? 0.8 * radius : 1.1 * radius;
  const double tilt = markers.shape == Marker::cross ? reach : 0.0;
  MarkerStrokes out;
  out.thickness = std::max(2.0, 0.22 * markers.size) + 2 * grow;
  out.lines[0] = {PixelPoint{c.x - reach, c.y - tilt}, PixelPoint{c.x + reach, c.y + tilt}};
  out.lines[1] = {PixelPoint{c.x - tilt, c.y + reach}, PixelPoint{c.x + tilt, c.y - reach}};
  return out;
}

std::vector<PixelPoint> regular_polygon(PixelPoint c, double radius, int corners, double turn) {
  std::vector<PixelPoint> out;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners + turn;
    out.push_back({c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)});
  }
  return out;
}

/// Radii that give all shapes about the area of the circle.
std::vector<PixelPoint> marker_corners(Marker shape, PixelPoint c, double radius) {
  constexpr double quarter = std::numbers::pi / 4;
  switch (shape) {
    case Marker::square:
      return regular_polygon(c, 1.25 * radius, 4, quarter);
    case Marker::diamond:
      return regular_polygon(c, 1.3 * radius, 4, 0.0);
    case Marker::triangle:
      return regular_polygon(c, 1.45 * radius, 3, -2 * quarter);
    default:
      return {};
  }
}

}  // namespace tribolog::render::figure
