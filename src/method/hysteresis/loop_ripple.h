#pragma once
// What torque ripple does to the parameters that are read from loops.

#include "method/gravity/ripple_spectrum.h"
#include "method/hysteresis/lugre_fit.h"

namespace tribolog::method::hysteresis {

/// Ripple of amplitude a and k periods to the motor's turn rises across a loop of half travel x by
/// up to a sin(k x) to each side: as a spring of stiffness a k does. That is in static and Coulomb
/// torque, in the stiffness, and, at the loop's angular frequency w, in the inertia as a k / w^2.
/// Its phase at the loop is nobody's: the intervals are widened by any.
LuGreFit with_ripple_of_loops(LuGreFit fit, const gravity::Ripple& ripple);

}  // namespace tribolog::method::hysteresis
