#include "render/figure/marker_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tribolog::render {

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

}  // namespace tribolog::render
