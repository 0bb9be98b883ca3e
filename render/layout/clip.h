#pragma once
// Data lines end at the axes box; whatever lies outside never reaches the painter.

#include <optional>
#include <utility>
#include <vector>

#include "render/figure/pixel_geometry.h"
#include "render/layout/polyline_simplifier.h"

namespace tribolog::render {

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

}  // namespace tribolog::render
