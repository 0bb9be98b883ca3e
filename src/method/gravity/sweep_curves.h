#pragma once
// A sweep's torque against the angle: its largest value, and the fitted curve.

#include <Eigen/Core>

#include "method/gravity/cog_sweep.h"
#include "method/motion/sweep_samples.h"

namespace tribolog::method::gravity {

/// Fills the `argmax` members of a result whose residual, gravity amplitude and range are known:
/// the sample of largest torque, and the angles that noise makes indistinguishable from it.
void find_torque_maximum(const motion::Sweep& sweep, CogSweepResult& result);

/// The fitted torque against the angle, for figures: measured torque less residual, the median of
/// equal bins of the angle. NaN where a direction has no samples in a bin.
/// @param result whose range is known.
void add_fit_curves(const motion::Sweep& sweep, const Eigen::VectorXd& residuals,
                    const CogSweepResult& result, SweepCurves& curves);

}  // namespace tribolog::method::gravity
