#include "method/gravity/torque_maximum.h"

#include <algorithm>
#include <cmath>

#include "method/gravity/sweep_regression.h"

namespace tribolog {

void find_torque_maximum(const std::vector<const Recording*>& recordings,
                         const SweepSamples& samples, CogSweepResult& result) {
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

}  // namespace tribolog
