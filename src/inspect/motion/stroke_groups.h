#pragma once
// Strokes that belong together: there and back over the same way, in the same time.

#include <cstddef>
#include <vector>

#include "inspect/motion/stroke_shape.h"

namespace tribolog {

struct StrokeGroup {
  std::vector<AngleStroke> strokes;  ///< In the order of time.
  std::vector<StrokeShape> shapes;   ///< Of each.
  bool is_steady{};                  ///< More than half of them.
  /// Most of a chain of strokes without rest belongs to none: mixed sines, for example.
  bool is_irregular{};

  [[nodiscard]] std::size_t first() const { return strokes.front().first; }
  [[nodiscard]] std::size_t last() const { return strokes.back().last; }
  [[nodiscard]] double travel_rad() const;   ///< Median of the strokes.
  [[nodiscard]] double speed_rad_s() const;  ///< Median of the strokes.
};

/// Groups in the order of time; a stroke like none of its neighbours is a group of its own. Travel
/// and time agree within 0.7 to 1.4 from one stroke to the next, speed of steady ones within 8 %; a
/// rest between is at most half as long as the shorter stroke. A half stroke at the start or the
/// end of a sine belongs to it, and so does a smaller one with which a narrow oscillation begins.
std::vector<StrokeGroup> group_strokes(const AngleTrace& trace, const StrokeFamily& family,
                                       double widest_oscillation_rad);

}  // namespace tribolog
