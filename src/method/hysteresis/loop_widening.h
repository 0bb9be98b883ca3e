#pragma once
// What torque ripple, a lag, and friction that changes with the motor's angle do to the parameters
// that are read from loops.

#include <vector>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/lugre_fit.h"

namespace tribolog::method::hysteresis {

/// Ripple of amplitude a and k periods to the motor's turn rises across a loop of half travel x by
/// up to a sin(k x) to each side: as a spring of stiffness a k does. That is in static and Coulomb
/// torque, in the stiffness, and, at the loop's angular frequency w, in the inertia as a k / w^2.
/// Taken off by the phase that the sweep shows (take_ripple_off_loop), a part of it stays: the
/// intervals are widened by that at any phase.
LuGreFit with_ripple_of_loops(LuGreFit fit, const gravity::Ripple& ripple);

/// Takes off a loop's torque what the sweep's ripple changes within it; its mean over the loop
/// stays, as the paper's loops have it. Only where the loop lies within the sweep's angles, and
/// where that is a noticeable part of the loop's height.
void take_ripple_off_loop(const gravity::CogSweepResult& sweep, double gear_ratio,
                          joint::Recording& loop);

/// A loop stands at one angle, and its friction is that of there: as far from the mean over all
/// angles as the sweep's friction is, at any phase, and as the mean over the loops leaves of it.
/// @param motor_angle_rad where the loops stand.
LuGreFit with_friction_of_angle(LuGreFit fit, const gravity::CogSweepResult& sweep,
                                const std::vector<double>& motor_angle_rad);

/// A lag that was taken off as a delay may be a filter's, which rounds the reversal too: by about
/// the square of the lag over the time in which the contact builds up.
LuGreFit with_lag_as_filter(LuGreFit fit, double lag_s);

}  // namespace tribolog::method::hysteresis
