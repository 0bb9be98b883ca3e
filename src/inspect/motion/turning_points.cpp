#include "inspect/motion/turning_points.h"

namespace tribolog {

std::vector<std::size_t> turning_points(const std::vector<double>& signal, std::size_t first,
                                        std::size_t last, double threshold) {
  std::vector<std::size_t> points;
  std::size_t lowest = first;
  std::size_t highest = first;
  std::size_t i = first;
  for (; i <= last; ++i) {
    if (signal[i] < signal[lowest]) lowest = i;
    if (signal[i] > signal[highest]) highest = i;
    if (signal[highest] - signal[lowest] >= threshold) break;
  }
  if (i > last) return points;
  double direction = lowest < highest ? 1 : -1;
  points.push_back(direction > 0 ? lowest : highest);
  std::size_t extreme = i;
  for (; i <= last; ++i) {
    const double beyond = direction * (signal[i] - signal[extreme]);
    if (beyond > 0) extreme = i;
    if (beyond > -threshold) continue;
    points.push_back(extreme);
    extreme = i;
    direction = -direction;
  }
  points.push_back(extreme);
  return points;
}

}  // namespace tribolog
