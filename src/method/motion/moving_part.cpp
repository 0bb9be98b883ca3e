#include "method/motion/moving_part.h"

#include <algorithm>
#include <cmath>

namespace tribolog::method::motion {

namespace {

std::vector<double> cut(const std::vector<double>& v, std::size_t first, std::size_t last) {
  if (v.empty()) return {};
  return {v.begin() + static_cast<std::ptrdiff_t>(first),
          v.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

joint::Recording moving_part(const joint::Recording& recording) {
  const std::size_t n = recording.size();
  if (n < 3) return recording;
  const auto [low, high] = std::minmax_element(recording.q_rad.begin(), recording.q_rad.end());
  // Within this share of the range of where it stood, the joint counts as standing.
  const double still = 0.01 * (*high - *low);
  const auto& q = recording.q_rad;
  std::size_t first = 0;
  while (first + 1 < n && std::abs(q[first + 1] - q.front()) <= still) ++first;
  std::size_t last = n;
  while (last > first + 1 && std::abs(q[last - 2] - q.back()) <= still) --last;
  // A handful of samples within the threshold is motion that has just begun, not rest.
  const std::size_t handful = std::max<std::size_t>(3, n / 100);
  if (first < handful) first = 0;
  if (n - last < handful) last = n;
  if (first == 0 && last == n) return recording;
  joint::Recording out = recording;
  out.t_s = cut(recording.t_s, first, last);
  out.q_rad = cut(recording.q_rad, first, last);
  out.dq_rad_s = cut(recording.dq_rad_s, first, last);
  out.torque_Nm = cut(recording.torque_Nm, first, last);
  out.z_rad = cut(recording.z_rad, first, last);
  out.dz_rad_s = cut(recording.dz_rad_s, first, last);
  out.temperature_C = cut(recording.temperature_C, first, last);
  out.skipped.push_back({Code{"skipped.at_rest"}, n - (last - first)});
  return out;
}

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

}  // namespace tribolog::method::motion
