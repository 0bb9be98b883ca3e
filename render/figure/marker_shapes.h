#pragma once
// What each marker looks like, for every writer.

#include <array>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render {

inline constexpr double marker_rim_px = 1.5;
inline constexpr Colour marker_rim_colour{255, 255, 255};

/// Dots are too small for one: in a cloud of them it would only eat their neighbours.
bool has_rim(const Markers& markers);

/// A cross or a plus, which is stroked; the others are filled.
bool is_stroked(Marker shape);

/// The two strokes of a cross or a plus. @param grow widens it by so many pixels on each side
struct MarkerStrokes {
  std::array<std::array<PixelPoint, 2>, 2> lines;
  double thickness{};
};
MarkerStrokes marker_strokes(const Markers& markers, PixelPoint centre, double grow);

/// The corners of a filled marker; none for a circle, whose radius is `marker_radius`.
std::vector<PixelPoint> marker_corners(Marker shape, PixelPoint centre, double radius);
double marker_radius(const Markers& markers, double grow);

std::vector<PixelPoint> regular_polygon(PixelPoint centre, double radius, int corners, double turn);

}  // namespace tribolog::render
