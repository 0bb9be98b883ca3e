#pragma once
// The strokes of a recorded angle: its stretches from turn to turn.

#include <cstddef>
#include <vector>

namespace tribolog {

/// A stretch of a recording between two reversals; the joint angle only rises or only falls in it
/// by more than the noise.
struct Stroke {
  std::size_t first{};
  std::size_t last{};   ///< Index of the turn at its end, which is the next stroke's first.
  double direction{};   ///< +1: rising, -1: falling.
  double travel_rad{};  ///< > 0
};

/// Strokes of an angle: a turn counts where the angle runs back by more than `noise_rad`.
std::vector<Stroke> find_strokes(const std::vector<double>& q_rad, double noise_rad);

}  // namespace tribolog
