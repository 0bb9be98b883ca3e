#include "inspect/motion/way.h"

#include <algorithm>

namespace tribolog {

Way::Way(const AngleTrace& trace, std::size_t first, std::size_t last)
    : trace_(&trace),
      first_(first),
      last_(last),
      sign_(trace.q_rad[last] < trace.q_rad[first] ? -1.0 : 1.0) {}

double Way::largest_wiggle_rad() const {
  double furthest = 0;
  double wiggle = 0;
  for (std::size_t i = first_; i <= last_; ++i) {
    furthest = std::max(furthest, at(i));
    wiggle = std::max(wiggle, furthest - at(i));
  }
  return wiggle;
}

std::vector<std::size_t> Way::passages(double band_rad) const {
  std::vector<std::size_t> reached{first_};
  double next = band_rad;
  for (std::size_t i = first_; i < last_; ++i) {
    while (at(i) >= next && next < travel_rad()) {
      reached.push_back(i);
      next += band_rad;
    }
  }
  reached.push_back(last_);
  return reached;
}

}  // namespace tribolog
