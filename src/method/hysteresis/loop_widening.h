#pragma once
// Effect of torque ripple, of a lag, and of friction that changes with the motor's angle on the
// parameters that are read from loops.

#include <optional>
#include <vector>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/lugre_fit.h"
#include "statistics/estimate.h"

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

/// A friction torque less the share of itself by which it was another where it was recorded.
/// @param method of the new interval, with the recorded one's as its value "interval".
statistics::Estimate at_the_runs(const statistics::Estimate& recorded,
                                 const statistics::Estimate& difference,
                                 Code method = "interval.at_the_runs");

/// Static and Coulomb torque as they are at the mean load, place and time of the runs; the bristle
/// stays that of the loops but for the torque's gain there: whether the load stiffens it, or acts
/// beside it, no recording tells.
/// @param friction by which share of itself it is logged as another where the loops were recorded;
/// absent: not known, and nothing is changed.
/// @param gain by which share of itself a change of the torque is logged too large there.
LuGreFit with_friction_of_runs(LuGreFit fit, const std::optional<statistics::Estimate>& friction,
                               const std::optional<statistics::Estimate>& gain);

/// Widens stiffness and static torque by what an elasto-plastic contact would have, where the loops
/// do not tell it from LuGre's.
LuGreFit with_rival_contacts(LuGreFit fit);

/// A lag looks like bristle damping that is smaller by stiffness times lag: the damping is known no
/// better than that of what is not known of the lag, whose size is uncertain, and which a filter
/// changes by up to half where it was taken off as a delay.
LuGreFit with_unknown_lag(LuGreFit fit, const LoopTiming& timing);

/// Widens intervals: a lag that was removed as a delay may be a filter's, which also rounds the
/// reversal, by about the square of the lag over the rise time of friction after it.
LuGreFit with_lag_as_filter(LuGreFit fit, double lag_s);

}  // namespace tribolog::method::hysteresis
