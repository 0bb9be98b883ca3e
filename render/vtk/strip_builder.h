#pragma once
// Lines and areas as one strip of quadrilaterals, the only shape that the painter fills.
//
// VTK joins thick segments with notches and repeats its dash pattern per segment; strips made here
// have round joins, and any number of separate parts can share one draw call. Their edges fade over
// one pixel, as smooth as many samples a pixel would make them and at the price of one.

#include <limits>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::vtk {

/// A corner of the strip.
struct StripPoint {
  figure::PixelPoint at;
  double cover{1};          ///< How much of the colour is there, from 0 (beyond the edge) to 1.
  figure::Colour colour{};  ///< With the cover in its alpha.
};

/// Collects pairs of points (left edge, right edge). Parts are tied by quads without area.
class StripBuilder {
 public:
  /// Markers outside of these rows of pixels are left out from now on.
  void show_rows(double top, double bottom) {
    top_ = top;
    bottom_ = bottom;
  }
  /// Of all that is added from now on.
  void use(figure::Colour colour) { colour_ = colour; }
  void add(const figure::Polyline& line);  ///< Cut into its dashes.
  void add(const figure::Ribbon& ribbon);
  void add(const figure::Polygon& polygon);
  /// `grow` widens every marker by so many pixels on each side (for its rim).
  void add(const figure::Markers& markers, double grow = 0.0);

  /// Pixel coordinates, two points to a pair.
  [[nodiscard]] const std::vector<StripPoint>& points() const { return points_; }
  void clear() { points_.clear(); }

 private:
  /// Across a line or an area: where it is cut, and what both ends have inside and outside.
  struct Section {
    figure::PixelPoint left;      ///< On one edge,
    figure::PixelPoint right;     ///< and on the other.
    figure::PixelPoint out_left;  ///< Unit vectors away from the area.
    figure::PixelPoint out_right;
    double cover{1};
  };
  void pair(StripPoint a, StripPoint b);
  void begin_part(StripPoint at);
  void end_part(StripPoint at);
  void add(const std::vector<Section>& sections);
  void stroke(const std::vector<figure::PixelPoint>& line, double width);
  void convex(const std::vector<figure::PixelPoint>& outline);

  std::vector<StripPoint> points_;
  figure::Colour colour_;
  double top_{-std::numeric_limits<double>::infinity()};
  double bottom_{std::numeric_limits<double>::infinity()};
};

}  // namespace tribolog::render::vtk
