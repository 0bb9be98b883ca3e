#include "method/viscous/plateau_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::viscous {
namespace {

constexpr double farthest = 5;         // standard deviations
constexpr double most_left_out = 0.2;  // of the samples

/// Whether two levels hold nearly all samples: the mean is then affected by rounding.
bool is_on_few_levels(const std::vector<double>& torque, double step) {
  constexpr double nearly_all = 0.95;
  std::map<long long, std::size_t> levels;
  for (const double t : torque) ++levels[std::llround(t / step)];
  std::vector<std::size_t> counts;
  for (const auto& [level, count] : levels) counts.push_back(count);
  std::sort(counts.rbegin(), counts.rend());
  const std::size_t two = counts[0] + (counts.size() > 1 ? counts[1] : 0);
  return static_cast<double>(two) > nearly_all * static_cast<double>(torque.size());
}

void leave_out_accelerated(const std::vector<double>& taken_off_Nm, double friction_Nm,
                           PlateauSamples& samples) {
  constexpr double most_of_friction = 0.05;
  if (taken_off_Nm.empty()) return;
  std::vector<char> counts = samples.counts;
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (std::abs(taken_off_Nm[samples.first + i]) <= most_of_friction * friction_Nm) continue;
    counts[i] = 0;
    ++left_out;
  }
  if (2 * left_out > counts.size()) return;
  samples.counts = std::move(counts);
  samples.left_out = left_out;
}

}  // namespace

PlateauSamples samples_that_count(const joint::Recording& recording, const motion::Plateau& plateau,
                                  const std::vector<double>& friction_Nm,
                                  const std::vector<double>& taken_off_Nm, double step) {
  PlateauSamples out{plateau.first, plateau.last, std::vector<char>(plateau.size(), 1), 0, 0};
  const auto at = [&](std::size_t i) {
    return recording.torque_Nm.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const std::vector<double> torque(at(plateau.first), at(plateau.last));
  // Neighbouring speeds and both directions round alike: their mean has the error of one of them,
  // and the curve bends by it where independent errors would cancel.
  constexpr double in_common = 2;
  if (step > 0 && is_on_few_levels(torque, step)) {
    out.rounding_error_Nm = in_common * step / std::sqrt(12.0);
  }

  const double middle = statistics::median(friction_Nm);
  leave_out_accelerated(taken_off_Nm, std::abs(middle), out);
  std::vector<double> off(friction_Nm.size());
  std::transform(friction_Nm.begin(), friction_Nm.end(), off.begin(),
                 [&](double f) { return std::abs(f - middle); });
  const double deviation = statistics::normal_sd_by_median_size * statistics::median(off);
  // A log without noise has no scatter to speak of, and then no outliers.
  constexpr double least_deviation = 2e-4;  // of friction
  const double fence = farthest * std::max({deviation, step, least_deviation * std::abs(middle)});
  if (!(fence > 0)) return out;
  PlateauSamples without = out;
  for (std::size_t i = 0; i < off.size(); ++i) {
    if (off[i] <= fence || without.counts[i] == 0) continue;
    without.counts[i] = 0;
    ++without.left_out;
  }
  const auto outliers = static_cast<double>(without.left_out - out.left_out);
  return outliers > most_left_out * static_cast<double>(off.size()) ? out : without;
}

}  // namespace tribolog::method::viscous
