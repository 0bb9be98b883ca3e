#include "stages/sweep_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribolog {

void add_fit_curves(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                    const Eigen::VectorXd& residuals, CogSweepResult& result) {
  constexpr std::size_t bins = 240;
  struct Sums {
    std::vector<double> torque = std::vector<double>(bins, 0.0);
    std::vector<double> count = std::vector<double>(bins, 0.0);
  };
  Sums rising;
  Sums falling;
  const double width = (result.highest_rad - result.lowest_rad) / static_cast<double>(bins);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Recording& r = *recordings[samples.recording[i]];
    const double q = r.q_rad[samples.index[i]];
    const auto bin = std::min(bins - 1, static_cast<std::size_t>((q - result.lowest_rad) / width));
    Sums& sums = samples.direction[i] > 0 ? rising : falling;
    sums.torque[bin] += r.torque_Nm[samples.index[i]] - residuals(static_cast<Eigen::Index>(i));
    sums.count[bin] += 1;
  }
  const auto mean = [](const Sums& sums, std::size_t bin) {
    return sums.count[bin] > 0 ? sums.torque[bin] / sums.count[bin]
                               : std::numeric_limits<double>::quiet_NaN();
  };
  for (std::size_t bin = 0; bin < bins; ++bin) {
    result.fit_q_rad.push_back(result.lowest_rad + (static_cast<double>(bin) + 0.5) * width);
    result.fit_rising_Nm.push_back(mean(rising, bin));
    result.fit_falling_Nm.push_back(mean(falling, bin));
  }
  if (!result.both_directions) {
    const bool up = std::any_of(samples.direction.begin(), samples.direction.end(),
                                [](double d) { return d > 0; });
    (up ? result.fit_falling_Nm : result.fit_rising_Nm).clear();
  }
}

}  // namespace tribolog
