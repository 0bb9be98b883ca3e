#pragma once
// The fitted torque of a sweep against the angle, for figures.

#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/motion/sweep_samples.h"

namespace tribolog {

/// Fills fit_q_rad, fit_rising_Nm and fit_falling_Nm: measured torque less residual, the median
/// of equal bins of the angle. An empty bin takes no part: it is NaN in the direction that lacks
/// it.
void add_fit_curves(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                    const Eigen::VectorXd& residuals, CogSweepResult& result);

}  // namespace tribolog
