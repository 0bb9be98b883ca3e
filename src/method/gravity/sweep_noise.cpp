#include "method/gravity/sweep_noise.h"

#include <cmath>

#include "statistics/white_noise.h"

namespace tribolog {

double white_torque_variance(const std::vector<const Recording*>& recordings,
                             const SweepSamples& samples) {
  std::vector<double> third;
  for (std::size_t i = 3; i < samples.size(); ++i) {
    const bool neighbours = samples.recording[i - 3] == samples.recording[i] &&
                            samples.index[i - 3] + 3 == samples.index[i];
    if (!neighbours) continue;
    const Recording& r = *recordings[samples.recording[i]];
    third.push_back(third_difference(&r.torque_Nm[samples.index[i] - 3]));
  }
  return white_variance(third);
}

double torque_ripple_Nm(double residual_sd_Nm, double white_variance) {
  constexpr double least_share = 0.05;
  const double rest = residual_sd_Nm * residual_sd_Nm - white_variance;
  return rest > least_share * white_variance ? std::sqrt(rest) : 0.0;
}

}  // namespace tribolog
