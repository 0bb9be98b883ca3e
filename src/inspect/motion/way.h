#pragma once
// One direction of a motion between two turning points.

#include <cstddef>
#include <vector>

#include "inspect/motion/angle_trace.h"

namespace tribolog {

/// The angle counted from its start, in its direction: it rises from 0 to its travel, but for
/// wiggles.
class Way {
 public:
  Way(const AngleTrace& trace, std::size_t first, std::size_t last);

  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t last() const { return last_; }
  [[nodiscard]] double travel_rad() const { return at(last_); }
  [[nodiscard]] double at(std::size_t i) const {
    return sign_ * (trace_->q_rad[i] - trace_->q_rad[first_]);
  }

  /// Largest fall behind the furthest point so far.
  [[nodiscard]] double largest_wiggle_rad() const;
  /// Samples at which it first reaches 0, 1, 2 ... bands; the last one is its end.
  [[nodiscard]] std::vector<std::size_t> passages(double band_rad) const;

 private:
  const AngleTrace* trace_;
  std::size_t first_;
  std::size_t last_;
  double sign_;
};

}  // namespace tribolog
