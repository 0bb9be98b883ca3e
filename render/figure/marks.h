#pragma once
// What lines and markers look like, for every writer.

#include <array>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/figure/figure.h"

namespace tribolog::render::figure {

/// Ink and gap in turn, in pixels; empty for a solid line. Scaled with the width, so that every
/// style looks alike in thin and thick.
std::vector<double> dash_lengths(LineStyle style, double width);

/// The inked parts of a line. @pre an even number of positive lengths, or none (the whole line).
std::vector<std::vector<PixelPoint>> cut_into_dashes(const std::vector<PixelPoint>& line,
                                                     const std::vector<double>& lengths);

// What each marker looks like, for every writer.

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

}  // namespace tribolog::render::figure
