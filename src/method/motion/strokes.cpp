#include "method/motion/strokes.h"

#include <cmath>

namespace tribolog {

std::vector<Stroke> find_strokes(const std::vector<double>& q, double noise_rad) {
  std::vector<Stroke> strokes;
  std::size_t low = 0;
  std::size_t high = 0;
  std::size_t start = 0;
  double direction = 0;
  const auto close = [&](std::size_t turn) {
    strokes.push_back({start, turn, direction, std::abs(q[turn] - q[start])});
    start = turn;
  };
  for (std::size_t i = 1; i < q.size(); ++i) {
    if (q[i] > q[high]) high = i;
    if (q[i] < q[low]) low = i;
    if (direction <= 0 && q[i] - q[low] > noise_rad) {
      if (direction < 0) close(low);
      direction = 1;
      start = low;
      high = i;
    } else if (direction >= 0 && q[high] - q[i] > noise_rad) {
      if (direction > 0) close(high);
      direction = -1;
      start = high;
      low = i;
    }
  }
  if (direction != 0) close(direction > 0 ? high : low);
  return strokes;
}

}  // namespace tribolog
