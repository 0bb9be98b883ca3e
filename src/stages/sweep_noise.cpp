#include "stages/sweep_noise.h"

#include <cmath>

namespace tribolog {

namespace {

/// Mean square of third differences, as a variance of the samples.
struct ThirdDifferences {
  double squares{}, count{};

  /// @param t the first of four neighbours.
  void add(const double* t) {
    const double third = t[3] - 3 * t[2] + 3 * t[1] - t[0];
    squares += third * third;
    count += 1;
  }
  [[nodiscard]] double variance() const {
    constexpr double gain = 20;  // 1 + 9 + 9 + 1
    return count > 0 ? squares / (gain * count) : 0.0;
  }
};

}  // namespace

double white_torque_variance(const std::vector<const Recording*>& recordings,
                             const SweepSamples& samples) {
  ThirdDifferences differences;
  for (std::size_t i = 3; i < samples.size(); ++i) {
    const bool neighbours = samples.recording[i - 3] == samples.recording[i] &&
                            samples.index[i - 3] + 3 == samples.index[i];
    if (!neighbours) continue;
    differences.add(&recordings[samples.recording[i]]->torque_Nm[samples.index[i] - 3]);
  }
  return differences.variance();
}

double white_torque_variance(const Recording& recording, std::size_t first, std::size_t last) {
  ThirdDifferences differences;
  for (std::size_t i = first + 3; i < last; ++i) differences.add(&recording.torque_Nm[i - 3]);
  return differences.variance();
}

double torque_ripple_Nm(double residual_sd_Nm, double white_variance) {
  constexpr double least_share = 0.05;
  const double rest = residual_sd_Nm * residual_sd_Nm - white_variance;
  return rest > least_share * white_variance ? std::sqrt(rest) : 0.0;
}

}  // namespace tribolog
