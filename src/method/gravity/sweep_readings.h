#pragma once
// Internal to the gravity stage: what a sweep's fit says of friction and offset.

#include <Eigen/Core>

#include "method/gravity/cog_sweep.h"
#include "method/gravity/sweep_regression.h"
#include "method/motion/sweep_samples.h"

namespace tribolog::method::gravity {

/// Half the mean of the rising offsets less that of the falling ones, as a linear combination of
/// coefficients.
Eigen::VectorXd direction_contrast(const SweepDesign& d, const motion::SweepSamples& samples);

/// The part of the two directions' mean torque that is not gravity, as a linear combination of
/// coefficients. The offsets were fitted against cos q - 1; the first coefficient has since been
/// subtracted from them.
Eigen::VectorXd offset_gradient(const SweepDesign& d, const motion::SweepSamples& samples);

/// Coulomb torque; at varying speed the offset, viscous coefficient and inertia as well.
void read_friction(const SweepDesign& d, const motion::SweepSamples& samples,
                   const SweepGravityFit& fit, double gear_ratio, CogSweepResult& out);

/// The offset and its interval; nothing from one direction alone.
void read_offset(const SweepDesign& d, const motion::SweepSamples& samples,
                 const SweepGravityFit& fit, CogSweepResult& out);

}  // namespace tribolog::method::gravity
