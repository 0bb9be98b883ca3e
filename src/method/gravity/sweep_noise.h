#pragma once
// Internal to the sweep stage: what of a residual is white noise, and what is not.

#include <vector>

#include "joint/recording.h"
#include "method/motion/sweep_samples.h"

namespace tribolog {

/// Variance of the white noise of the torque [N²·m²] from third differences of neighbouring
/// samples, in which everything slower than a few samples drops out. 0 without neighbours.
double white_torque_variance(const std::vector<const Recording*>& recordings,
                             const SweepSamples& samples);

/// Standard deviation of what the residual holds beyond white noise [N·m]: torque ripple, friction
/// that changes with the angle. 0 below what sampling of the two variances explains.
double torque_ripple_Nm(double residual_sd_Nm, double white_variance);

}  // namespace tribolog
