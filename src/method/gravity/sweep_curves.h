#pragma once
// A sweep's torque against the angle: its largest value, and the fitted curve.

#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/motion/sweep_samples.h"

namespace tribolog::method::gravity {

/// Fills the `argmax` members of a result whose residual, gravity amplitude and range are known:
/// the sample of largest torque, and the angles that the noise cannot tell from it.
void find_torque_maximum(const std::vector<const joint::Recording*>& recordings,
                         const motion::SweepSamples& samples, CogSweepResult& result);

// The fitted torque of a sweep against the angle, for figures.

/// Fills fit_q_rad, fit_rising_Nm and fit_falling_Nm: measured torque less residual, the median
/// of equal bins of the angle. An empty bin takes no part: it is NaN in the direction that lacks
/// it.
void add_fit_curves(const std::vector<const joint::Recording*>& recordings,
                    const motion::SweepSamples& samples, const Eigen::VectorXd& residuals,
                    CogSweepResult& result);

}  // namespace tribolog::method::gravity
