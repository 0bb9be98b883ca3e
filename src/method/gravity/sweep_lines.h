#pragma once
// Internal to the gravity stage: ripple and vibration in the residual of a sweep, fitted with it.

#include <cstddef>
#include <vector>

#include "method/gravity/cog_sweep.h"
#include "method/gravity/sweep_regression.h"
#include "method/motion/sweep_samples.h"

namespace tribolog::method::gravity {

/// Finds ripple and vibration in the residual, and fits without them.
/// @param rivals receives the fit with them, where they are the shape of something else.
SweepGravityFit fit_without_lines(const motion::Sweep& sweep, double gear_ratio, double middle,
                                  const std::vector<std::size_t>& blocks,
                                  const SweepGravityFit& first, SweepDesign& design,
                                  CogSweepResult& out, std::vector<SweepGravityFit>& rivals);

}  // namespace tribolog::method::gravity
