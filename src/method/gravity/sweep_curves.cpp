#include "method/gravity/sweep_curves.h"

#include <algorithm>
#include <cmath>

#include "statistics/median.h"

namespace tribolog {

void add_fit_curves(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                    const Eigen::VectorXd& residuals, CogSweepResult& result) {
  constexpr std::size_t bins = 240;
  // The median: a few samples of an abrupt stop, with its torque of inertia, must not bend the
  // curve.
  std::vector<std::vector<double>> rising(bins);
  std::vector<std::vector<double>> falling(bins);
  const double width = (result.highest_rad - result.lowest_rad) / static_cast<double>(bins);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Recording& r = *recordings[samples.recording[i]];
    const double q = r.q_rad[samples.index[i]];
    const auto bin = std::min(bins - 1, static_cast<std::size_t>((q - result.lowest_rad) / width));
    (samples.direction[i] > 0 ? rising : falling)[bin].push_back(
        r.torque_Nm[samples.index[i]] - residuals(static_cast<Eigen::Index>(i)));
  }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    result.fit_q_rad.push_back(result.lowest_rad + (static_cast<double>(bin) + 0.5) * width);
    result.fit_rising_Nm.push_back(median(rising[bin]));
    result.fit_falling_Nm.push_back(median(falling[bin]));
  }
  if (!result.both_directions) {
    const bool up = std::any_of(samples.direction.begin(), samples.direction.end(),
                                [](double d) { return d > 0; });
    (up ? result.fit_falling_Nm : result.fit_rising_Nm).clear();
  }
}

}  // namespace tribolog
