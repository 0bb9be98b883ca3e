#pragma once
// Residuals of a fitted loop, averaged over equal bins of the angle: scatter averages out there,
// and what remains is the model's error.

#include <cstddef>
#include <vector>

#include "joint/recording.h"

namespace tribolog::method::hysteresis {

struct LoopMisfit {
  std::vector<double> q_rad;       ///< Centres of the bins that both directions pass.
  std::vector<double> rising_Nm;   ///< Mean of T - model while the angle grows.
  std::vector<double> falling_Nm;  ///< While it falls.
  /// Root mean square of both, less the scatter that remains in the means of bins.
  double systematic_Nm{};
};

/// @param model_Nm torque of the model at the recording's samples.
/// @param speed of the motion there, of any unit: > 0 rising, < 0 falling.
LoopMisfit loop_misfit(const joint::Recording& recording, const std::vector<double>& model_Nm,
                       const std::vector<double>& speed);

/// What repeats from stroke to stroke of T - model, at the same share of the stroke: root mean
/// square over both directions, less the scatter that remains in the means. 0 with fewer than three
/// strokes in a direction.
/// @param turns_s reversals between the strokes, since the recording's first sample.
/// @param first sample that counts.
double repeated_misfit_Nm(const joint::Recording& recording, const std::vector<double>& model_Nm,
                          const std::vector<double>& turns_s, std::size_t first);

}  // namespace tribolog::method::hysteresis
