#include "stages/sweep_noise.h"

#include <cmath>

namespace tribolog {

double white_torque_variance(const std::vector<const Recording*>& recordings,
                             const SweepSamples& samples) {
  double squares = 0;
  double count = 0;
  for (std::size_t i = 3; i < samples.size(); ++i) {
    const bool neighbours = samples.recording[i - 3] == samples.recording[i] &&
                            samples.index[i - 3] + 3 == samples.index[i];
    if (!neighbours) continue;
    const double* t = &recordings[samples.recording[i]]->torque_Nm[samples.index[i] - 3];
    const double third = t[3] - 3 * t[2] + 3 * t[1] - t[0];
    squares += third * third;
    count += 1;
  }
  constexpr double gain = 20;  // 1 + 9 + 9 + 1
  return count > 0 ? squares / (gain * count) : 0.0;
}

double torque_ripple_Nm(double residual_sd_Nm, double white_variance) {
  constexpr double least_share = 0.05;
  const double rest = residual_sd_Nm * residual_sd_Nm - white_variance;
  return rest > least_share * white_variance ? std::sqrt(rest) : 0.0;
}

}  // namespace tribolog
