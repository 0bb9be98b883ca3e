#include "method/hysteresis/turn_stiffness.h"

#include <algorithm>
#include <cmath>

#include "statistics/student_t.h"

namespace tribolog {

double compliance(const std::vector<double>& torque_Nm, const std::vector<double>& q_rad,
                  std::size_t first, std::size_t last) {
  const auto n = static_cast<double>(last - first);
  double mean_t = 0;
  double mean_q = 0;
  for (std::size_t i = first; i < last; ++i) {
    mean_t += torque_Nm[i] / n;
    mean_q += q_rad[i] / n;
  }
  double by_t = 0;
  double by_q = 0;
  for (std::size_t i = first; i < last; ++i) {
    by_t += std::pow(torque_Nm[i] - mean_t, 2);
    by_q += (torque_Nm[i] - mean_t) * (q_rad[i] - mean_q);
  }
  return by_t > 0 ? by_q / by_t : 0;
}

Estimate stiffness_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0;
  for (const double v : values) mean += v / n;
  double squares = 0;
  for (const double v : values) squares += std::pow(v - mean, 2);
  const double half = student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n);
  const double share = std::min(half / mean, 0.99);
  return {1 / mean, 1 / (mean * (1 + share)), 1 / (mean * (1 - share)), "scatter of the strokes"};
}

std::optional<Estimate> stiffness_behind_turns(const std::vector<double>& q_rad,
                                               const std::vector<double>& measured_Nm,
                                               const std::vector<double>& torque_Nm,
                                               const std::vector<StrokeSamples>& strokes) {
  std::vector<double> all;
  for (const StrokeSamples& stroke : strokes) {
    const double start = measured_Nm[stroke.first];
    double height = 0;
    for (std::size_t i = stroke.first; i < stroke.last; ++i) {
      height = std::max(height, std::abs(measured_Nm[i] - start));
    }
    std::size_t last = stroke.first;
    while (last < stroke.last && std::abs(measured_Nm[last] - start) < part_behind_turn * height) {
      ++last;
    }
    if (last - stroke.first < fewest_samples_behind_turn) continue;
    const double c = compliance(torque_Nm, q_rad, stroke.first, last);
    if (c > 0) all.push_back(c);
  }
  if (all.size() < 2) return std::nullopt;
  return stiffness_of(all);
}

}  // namespace tribolog
