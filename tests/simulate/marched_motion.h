#pragma once
// Force-driven motion by short equal steps with each model's own advance(): for models that jump,
// which a solver of smooth equations cannot follow, and to check that solver.

#include "simulate/forced_motion.h"

namespace tribolog::test {

/// Second order in the step where the motion is smooth. A step in which the speed would change its
/// sign ends at rest; a contact without pre-sliding then holds up to the torque with which sliding
/// begins. Samples lie at whole multiples of `step_s` next to those of the set-up.
simulate::ForcedMotion marched_motion(const friction::DynamicFriction& friction,
                                      const simulate::ForcedMotionSetup& setup, double step_s,
                                      bool holds_by_itself);

}  // namespace tribolog::test
