#pragma once
// What a joint did over time, as far as its motion is cut into segments.

#include <cstddef>
#include <vector>

namespace tribolog {

struct AngleTrace {
  std::vector<double> t_s;    ///< Strictly increasing.
  std::vector<double> q_rad;  ///< Angle; no gaps.
  /// Torque or current in any unit, of the same length, without gaps; empty: none was recorded.
  std::vector<double> effort;

  [[nodiscard]] std::size_t size() const { return t_s.size(); }
};

}  // namespace tribolog
