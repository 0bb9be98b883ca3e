#pragma once
// Residuals of a fitted loop, averaged over equal bins of the angle: scatter averages out there,
// and what remains is the model's error.

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

}  // namespace tribolog::method::hysteresis
