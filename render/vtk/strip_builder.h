#pragma once
// Lines and areas as one strip of quadrilaterals, the only shape that the painter fills.
//
// VTK joins thick segments with notches and repeats its dash pattern per segment; strips made here
// have round joins, and any number of separate parts can share one draw call.

#include <limits>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render {

/// Collects pairs of points (left edge, right edge). Parts are tied by quads without area.
class StripBuilder {
 public:
  /// Markers outside of these rows of pixels are left out from now on.
  void show_rows(double top, double bottom) {
    top_ = top;
    bottom_ = bottom;
  }
  void add(const Polyline& line);  ///< Cut into its dashes.
  void add(const Ribbon& ribbon);
  void add(const Polygon& polygon);
  /// `grow` widens every marker by so many pixels on each side (for its rim).
  void add(const Markers& markers, double grow = 0.0);

  /// Pixel coordinates, two points to a pair.
  [[nodiscard]] const std::vector<PixelPoint>& points() const { return points_; }
  void clear() { points_.clear(); }

 private:
  void pair(PixelPoint a, PixelPoint b);
  void begin_part(PixelPoint at);
  void end_part(PixelPoint at);
  void stroke(const std::vector<PixelPoint>& line, double width);
  void convex(const std::vector<PixelPoint>& outline);

  std::vector<PixelPoint> points_;
  double top_{-std::numeric_limits<double>::infinity()};
  double bottom_{std::numeric_limits<double>::infinity()};
};

}  // namespace tribolog::render
