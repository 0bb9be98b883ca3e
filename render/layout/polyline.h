#pragma once
// Lines of data, made ready for the picture: cut at the axes, and with no more points than it
// shows.

#include <optional>
#include <utility>
#include <vector>

#include "render/figure/draw_list.h"

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

// Data lines end at the axes box; whatever lies outside never reaches the painter.

using PixelSegment = std::pair<PixelPoint, PixelPoint>;

/// The part of a segment inside the box (Liang and Barsky).
std::optional<PixelSegment> clipped(const PixelSegment& segment, const PixelBox& box);

/// Takes points in turn, `lift()` where the line is broken, and yields simplified lines inside the
/// box.
class LineCollector {
 public:
  explicit LineCollector(const PixelBox& box) : box_(box) {}
  void add(PixelPoint point);
  void lift();
  std::vector<std::vector<PixelPoint>> take();

 private:
  void end_line();

  PixelBox box_;
  bool has_previous_{false};
  PixelPoint previous_;
  bool drawing_{false};
  PolylineSimplifier simplifier_;
  std::vector<std::vector<PixelPoint>> lines_;
};

// Where lines run.

/// Whether a point is within `reach` of a line.
bool lies_on(const std::vector<PixelPoint>& line, PixelPoint p, double reach);

/// Whether some of a line is inside a box; touching its border is not.
bool enters(const std::vector<PixelPoint>& line, const PixelBox& box);

}  // namespace tribolog::render
