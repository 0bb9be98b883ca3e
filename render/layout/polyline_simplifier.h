#pragma once
// Fewer points for the same picture.

#include <vector>

#include "render/figure/pixel_geometry.h"

namespace tribolog::render {

/// Nothing in a simplified line is farther than this from the original, nor the other way round;
/// twice as much where a noisy signal goes up and down within a quarter of a pixel column.
inline constexpr double simplification_tolerance_px = 0.25;

/// Takes the points of one unbroken line in turn and keeps those that matter, in one pass: first,
/// points that go up and down within a quarter of a pixel column shrink to one stroke over their
/// vertical reach (a noisy signal consists of little else); then points near the straight line
/// between their neighbours go.
class PolylineSimplifier {
 public:
  void add(PixelPoint point);
  /// Ends the line; the object is then ready for the next one.
  std::vector<PixelPoint> take();

 private:
  void flush_column(bool line_ends);
  void add_to_sector(PixelPoint point);
  void restart_sector(PixelPoint anchor);

  std::vector<PixelPoint> kept_;

  double column_{};
  std::vector<PixelPoint> in_this_column_;
  PixelPoint pen_;  ///< Where the previous column was left.
  bool has_pen_{false};

  bool has_candidate_{false};
  PixelPoint candidate_;
  double reach_{};
  bool open_{true};  ///< No direction bound yet.
  PixelPoint bound_left_, bound_right_;
};

std::vector<PixelPoint> simplified(const std::vector<PixelPoint>& line);

}  // namespace tribolog::render
