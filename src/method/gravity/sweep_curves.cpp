#include "method/gravity/sweep_curves.h"

#include <algorithm>
#include <cmath>

#include "method/gravity/sweep_regression.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::gravity {

void find_torque_maximum(const std::vector<const joint::Recording*>& recordings,
                         const motion::SweepSamples& samples, CogSweepResult& result) {
  std::size_t best = 0;
  const auto torque = [&](std::size_t i) {
    return recordings[samples.recording[i]]->torque_Nm[samples.index[i]];
  };
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (torque(i) > torque(best)) best = i;
  }
  result.argmax_rad = angle_of(recordings, samples, best);
  result.argmax_torque_Nm = torque(best);
  // Among N noisy samples the largest exceeds the curve by about sd sqrt(2 ln N); the curve may lie
  // lower by as much at the true peak's neighbours. Never narrower than the sampling.
  const double excess =
      result.residual_Nm * std::sqrt(2 * std::log(static_cast<double>(samples.size())));
  const double spacing =
      std::abs(samples.speed_rad_s[best]) *
      (recordings[samples.recording[best]]->t_s[1] - recordings[samples.recording[best]]->t_s[0]);
  const double reach =
      std::acos(std::clamp(1 - excess / result.gravity_Nm.value, -1.0, 1.0)) + spacing;
  result.argmax_low_rad =
      std::max(result.argmax_rad - reach, std::min(result.lowest_rad, result.argmax_rad));
  result.argmax_high_rad =
      std::min(result.argmax_rad + reach, std::max(result.highest_rad, result.argmax_rad));
  const double edge = 0.01 * (result.highest_rad - result.lowest_rad);
  result.argmax_at_end =
      result.argmax_rad - result.lowest_rad < edge || result.highest_rad - result.argmax_rad < edge;
}

void add_fit_curves(const std::vector<const joint::Recording*>& recordings,
                    const motion::SweepSamples& samples, const Eigen::VectorXd& residuals,
                    CogSweepResult& result) {
  constexpr std::size_t bins = 240;
  // The median: a few samples of an abrupt stop, with its torque of inertia, must not bend the
  // curve.
  std::vector<std::vector<double>> rising(bins);
  std::vector<std::vector<double>> falling(bins);
  const double width = (result.highest_rad - result.lowest_rad) / static_cast<double>(bins);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const joint::Recording& r = *recordings[samples.recording[i]];
    const double q = r.q_rad[samples.index[i]];
    const auto bin = std::min(bins - 1, static_cast<std::size_t>((q - result.lowest_rad) / width));
    (samples.direction[i] > 0 ? rising : falling)[bin].push_back(
        r.torque_Nm[samples.index[i]] - residuals(static_cast<Eigen::Index>(i)));
  }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    result.fit_q_rad.push_back(result.lowest_rad + (static_cast<double>(bin) + 0.5) * width);
    result.fit_rising_Nm.push_back(statistics::median(rising[bin]));
    result.fit_falling_Nm.push_back(statistics::median(falling[bin]));
  }
  if (!result.both_directions) {
    const bool up = std::any_of(samples.direction.begin(), samples.direction.end(),
                                [](double d) { return d > 0; });
    (up ? result.fit_falling_Nm : result.fit_rising_Nm).clear();
  }
}

}  // namespace tribolog::method::gravity
