#include "method/gravity/sweep_curves.h"

#include <algorithm>
#include <cmath>

#include "method/gravity/sweep_regression.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::gravity {

void find_torque_maximum(const motion::Sweep& sweep, CogSweepResult& result) {
  const motion::SweepSamples& samples = sweep.samples;
  std::size_t best = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (sweep.torque_Nm(i) > sweep.torque_Nm(best)) best = i;
  }
  result.argmax_rad = sweep.q_rad(best);
  result.argmax_torque_Nm = sweep.torque_Nm(best);
  // Among N noisy samples the largest exceeds the curve by about sd sqrt(2 ln N); the curve may lie
  // lower by as much at the true peak's neighbours. Never narrower than the sampling.
  const double excess =
      result.residual_Nm * std::sqrt(2 * std::log(static_cast<double>(samples.size())));
  const std::vector<double>& t_s = sweep.recordings[samples.recording[best]]->t_s;
  const double spacing = std::abs(samples.speed_rad_s[best]) * (t_s[1] - t_s[0]);
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

void add_fit_curves(const motion::Sweep& sweep, const Eigen::VectorXd& residuals,
                    const CogSweepResult& result, SweepCurves& curves) {
  const motion::SweepSamples& samples = sweep.samples;
  constexpr std::size_t bins = 240;
  // The median: a few samples of an abrupt stop, with its torque of inertia, must not bend the
  // curve.
  std::vector<std::vector<double>> rising(bins);
  std::vector<std::vector<double>> falling(bins);
  const double width = (result.highest_rad - result.lowest_rad) / static_cast<double>(bins);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto bin =
        std::min(bins - 1, static_cast<std::size_t>((sweep.q_rad(i) - result.lowest_rad) / width));
    (samples.direction[i] > 0 ? rising : falling)[bin].push_back(
        sweep.torque_Nm(i) - residuals(static_cast<Eigen::Index>(i)));
  }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    curves.fit_q_rad.push_back(result.lowest_rad + (static_cast<double>(bin) + 0.5) * width);
    curves.fit_rising_Nm.push_back(statistics::median(rising[bin]));
    curves.fit_falling_Nm.push_back(statistics::median(falling[bin]));
  }
  if (!result.both_directions) {
    const bool up = std::any_of(samples.direction.begin(), samples.direction.end(),
                                [](double d) { return d > 0; });
    (up ? curves.fit_falling_Nm : curves.fit_rising_Nm).clear();
  }
}

}  // namespace tribolog::method::gravity
