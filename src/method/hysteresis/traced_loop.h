#pragma once
// What the fit of a loop along a traced motion tells besides the numbers: how well the motion is
// known, how much of the scatter its noise explains, and whether the model is as stiff behind a
// reversal as the joint was measured to be.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "method/motion/traced_motion.h"
#include "statistics/estimate.h"

namespace tribolog {

struct TracedLoop {
  double noise_rad{};          ///< Of the angle, standard deviation, joint side.
  std::string noise_in_words;  ///< What tells it.
  std::size_t strokes{};       ///< Between reversals.
  /// Scatter of the torque that the noise of angle and torque can explain: the angle's noise times
  /// the model's slope, and the torque's white noise.
  double explained_Nm{};
  /// Torque at the motor over joint angle behind the reversals (stages/turn_stiffness.h), measured
  /// and of the model over the same samples; absent where fewer than two strokes show it.
  std::optional<Estimate> turn_stiffness_Nm_rad;
  std::optional<Estimate> model_turn_stiffness_Nm_rad;
};

/// @param model_Nm torque of the model at the recording's samples.
/// @param slope_Nm_rad of the model there, by motor angle.
TracedLoop describe_traced_loop(const Recording& recording, const TracedMotion& motion,
                                const std::vector<double>& model_Nm,
                                const std::vector<double>& slope_Nm_rad, double gear_ratio);

/// What the fit left where noise does not explain it, in words; empty where it does.
std::string misfit_in_words(const std::string& recording, const TracedLoop& loop,
                            double residual_Nm);

}  // namespace tribolog
