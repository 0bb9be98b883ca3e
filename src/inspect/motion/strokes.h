#pragma once
// The strokes of a motion: from one stand or reversal to the next.
//
// Found from the largest scale down, so that one recording may hold a sweep over the whole range
// and an oscillation ten thousand times smaller. At each scale the angle is cut at its turning
// points, wiggles below a twentieth of the range passed over; where it stays at a turning point
// longer than a reversal takes, it rests. Each rest is then looked at in the same way on the scale
// of its own range, down to the noise floor. No threshold is an angle or a time: the cut is the
// same in degrees and radians, in seconds and milliseconds.

#include <cstddef>
#include <vector>

#include "inspect/motion/angle_trace.h"

namespace tribolog::inspect::motion {

struct AngleStroke {
  std::size_t first{};  ///< Sample with which it leaves its stand or turns.
  std::size_t last{};   ///< Sample with which it comes to its stand or turns.
  double travel_rad{};  ///< Signed.
  /// Whether it begins where the one before ends, without a rest in between.
  bool follows_on{};
};

/// Strokes of one scale within one stretch of time, in the order of time.
using StrokeFamily = std::vector<AngleStroke>;

/// @param noise_floor_rad changes below it are no motion.
/// @return families, larger scales first; none in a trace at rest.
std::vector<StrokeFamily> find_strokes(const AngleTrace& trace, double noise_floor_rad);

}  // namespace tribolog::inspect::motion
