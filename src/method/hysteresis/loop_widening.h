#pragma once
// Effect of torque ripple, of a lag, and of friction that changes with the motor's angle on the
// parameters that are read from loops.

#include <vector>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/lugre_fit.h"

namespace tribolog::method::hysteresis {

/// Ripple of amplitude a and k periods per motor turn rises across a loop of half travel x by up to
/// a sin(k x) to each side, like a spring of stiffness a k. That enters static and Coulomb torque,
/// the stiffness and, at the loop's angular frequency w, the inertia as a k / w^2. Where it is
/// subtracted with the phase found in the sweep (take_ripple_off_loop), a part of it remains: the
/// intervals are widened by that part at any phase.
LuGreFit with_ripple_of_loops(LuGreFit fit, const gravity::Ripple& ripple);

/// Subtracts from a loop's torque the variation of the sweep's ripple within it; the ripple's mean
/// over the loop stays, as in the paper's loops. Only where the loop lies within the sweep's
/// angles, and where that is an appreciable part of the loop's height.
void take_ripple_off_loop(const gravity::CogSweepResult& sweep, double gear_ratio,
                          joint::Recording& loop);

/// A loop stands at one angle, with the friction there: its difference to the mean over all angles
/// is as large as in the sweep, at any phase, less what the mean over the loops averages out.
/// @param motor_angle_rad where the loops stand.
LuGreFit with_friction_of_angle(LuGreFit fit, const gravity::CogSweepResult& sweep,
                                const std::vector<double>& motor_angle_rad);

/// Widens stiffness and static torque by what an elasto-plastic contact would have, where the loops
/// do not tell it from LuGre's.
LuGreFit with_rival_contacts(LuGreFit fit);

/// Widens intervals: a lag that was removed as a delay may be a filter's, which also rounds the
/// reversal, by about the square of the lag over the rise time of friction after it.
LuGreFit with_lag_as_filter(LuGreFit fit, double lag_s);

}  // namespace tribolog::method::hysteresis
