#pragma once
// A line of text beside the point that it names.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/figure/pixel_geometry.h"
#include "render/text/text_line.h"

namespace tribolog::render {

/// 0 inside of the box.
inline double distance_to(const PixelBox& box, PixelPoint p) {
  const double dx = std::max({box.left - p.x, 0.0, p.x - box.right});
  const double dy = std::max({box.top - p.y, 0.0, p.y - box.bottom});
  return std::hypot(dx, dy);
}

/// Where a line starts (left end, on the baseline) so that the edge of its box lies `distance_px`
/// from the point in direction `k` of so many around it, the first up right. A box that would stick
/// out is pulled into the room.
inline PixelPoint start_beside(PixelPoint point, const TextLine& line, double distance_px, int k,
                               int directions, const PixelBox& room) {
  const double angle = std::numbers::pi * (2.0 * k / directions + 0.25);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double half_width = line.width / 2;
  const double half_height = line.height() / 2;
  // From the point to the centre of the box: the distance plus the box's own reach that way.
  const double x =
      point.x + cosine * distance_px + std::clamp(cosine * 1.5, -1.0, 1.0) * half_width;
  const double y = point.y - sine * distance_px - std::clamp(sine * 1.5, -1.0, 1.0) * half_height;
  const double left =
      std::clamp(x - half_width, room.left, std::max(room.left, room.right - line.width));
  const double top =
      std::clamp(y - half_height, room.top, std::max(room.top, room.bottom - line.height()));
  return {left, top + line.ascent};
}

}  // namespace tribolog::render
