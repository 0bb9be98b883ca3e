#pragma once
// Lines of data, made ready for the picture: cut at the axes, and with no more points than it
// shows.

#include <optional>
#include <utility>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::layout {

/// Nothing in a simplified line is farther than this from the original, nor the other way round;
/// twice as much where a noisy signal goes up and down within a quarter of a pixel column.
inline constexpr double simplification_tolerance_px = 0.25;

/// Takes the points of one unbroken line in turn and keeps those that matter, in one pass: first,
/// points that go up and down within a quarter of a pixel column shrink to one stroke over their
/// vertical reach (a noisy signal consists of little else); then points near the straight line
/// between their neighbours go.
class PolylineSimplifier {
 public:
  void add(figure::PixelPoint point);
  /// Ends the line; the object is then ready for the next one.
  std::vector<figure::PixelPoint> take();

 private:
  void flush_column(bool line_ends);
  void add_to_sector(figure::PixelPoint point);
  void restart_sector(figure::PixelPoint anchor);

  std::vector<figure::PixelPoint> kept_;

  double column_{};
  std::vector<figure::PixelPoint> in_this_column_;
  figure::PixelPoint pen_;  ///< Where the previous column was left.
  bool has_pen_{false};

  bool has_candidate_{false};
  figure::PixelPoint candidate_;
  double reach_{};
  bool open_{true};  ///< No direction bound yet.
  figure::PixelPoint bound_left_, bound_right_;
};

std::vector<figure::PixelPoint> simplified(const std::vector<figure::PixelPoint>& line);

// Data lines end at the axes box; whatever lies outside never reaches the painter.

using PixelSegment = std::pair<figure::PixelPoint, figure::PixelPoint>;

/// The part of a segment inside the box (Liang and Barsky).
std::optional<PixelSegment> clipped(const PixelSegment& segment, const figure::PixelBox& box);

/// Takes points in turn, `lift()` where the line is broken, and yields simplified lines inside the
/// box.
class LineCollector {
 public:
  explicit LineCollector(const figure::PixelBox& box) : box_(box) {}
  void add(figure::PixelPoint point);
  void lift();
  std::vector<std::vector<figure::PixelPoint>> take();

 private:
  void end_line();

  figure::PixelBox box_;
  bool has_previous_{false};
  figure::PixelPoint previous_;
  bool drawing_{false};
  PolylineSimplifier simplifier_;
  std::vector<std::vector<figure::PixelPoint>> lines_;
};

// Where lines run.

/// Whether a point is within `reach` of a line.
bool lies_on(const std::vector<figure::PixelPoint>& line, figure::PixelPoint p, double reach);

/// Whether some of a line is inside a box; touching its border is not.
bool enters(const std::vector<figure::PixelPoint>& line, const figure::PixelBox& box);

}  // namespace tribolog::render::layout
