#pragma once
// Internal to the sweep stage: the paper's way of finding the gravity peak, at the largest torque.

#include <vector>

#include "method/gravity/cog_sweep.h"
#include "method/motion/sweep_samples.h"

namespace tribolog {

/// Fills the `argmax` members of a result whose residual, gravity amplitude and range are known:
/// the sample of largest torque, and the angles that the noise cannot tell from it.
void find_torque_maximum(const std::vector<const Recording*>& recordings,
                         const SweepSamples& samples, CogSweepResult& result);

}  // namespace tribolog
