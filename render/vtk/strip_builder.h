#pragma once
// Lines and areas as one strip of quadrilaterals, the only shape that the painter fills.
//
// VTK joins thick segments with notches and repeats its dash pattern per segment; strips made here
// have round joins, and any number of separate parts can share one draw call.

#include <limits>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::vtk {

/// Collects pairs of points (left edge, right edge). Parts are tied by quads without area.
class StripBuilder {
 public:
  /// Markers outside of these rows of pixels are left out from now on.
  void show_rows(double top, double bottom) {
    top_ = top;
    bottom_ = bottom;
  }
  void add(const figure::Polyline& line);  ///< Cut into its dashes.
  void add(const figure::Ribbon& ribbon);
  void add(const figure::Polygon& polygon);
  /// `grow` widens every marker by so many pixels on each side (for its rim).
  void add(const figure::Markers& markers, double grow = 0.0);

  /// Pixel coordinates, two points to a pair.
  [[nodiscard]] const std::vector<figure::PixelPoint>& points() const { return points_; }
  void clear() { points_.clear(); }

 private:
  void pair(figure::PixelPoint a, figure::PixelPoint b);
  void begin_part(figure::PixelPoint at);
  void end_part(figure::PixelPoint at);
  void stroke(const std::vector<figure::PixelPoint>& line, double width);
  void convex(const std::vector<figure::PixelPoint>& outline);

  std::vector<figure::PixelPoint> points_;
  double top_{-std::numeric_limits<double>::infinity()};
  double bottom_{std::numeric_limits<double>::infinity()};
};

}  // namespace tribolog::render::vtk
