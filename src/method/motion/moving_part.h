#pragma once
// The strokes of a recorded angle, and the part of a recording in which the joint moves.

#include <cstddef>
#include <vector>

#include "joint/recording.h"

namespace tribolog::method::motion {

/// The recording without the rest before and after its motion, which would spoil a fit of cycles.
/// What is cut is counted among the skipped rows. A recording without rest is returned unchanged.
joint::Recording moving_part(const joint::Recording& recording);

// The strokes of a recorded angle: its stretches between reversals.

/// A stretch of a recording between two reversals; apart from noise, the joint angle only rises or
/// only falls in it.
struct Stroke {
  std::size_t first{};
  std::size_t last{};   ///< Index of the reversal at its end, which is the next stroke's first.
  double direction{};   ///< +1: rising, -1: falling.
  double travel_rad{};  ///< > 0
};

/// Strokes of an angle: a reversal counts where the angle runs back by more than `noise_rad`.
std::vector<Stroke> find_strokes(const std::vector<double>& q_rad, double noise_rad);

}  // namespace tribolog::method::motion
