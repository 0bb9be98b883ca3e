#pragma once
// Loops without the ripple within them, and their friction as it is where the runs are.

#include <optional>
#include <vector>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/lugre_fit.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// Subtracts from a loop's torque the variation of the sweep's ripple within it; the ripple's mean
/// over the loop stays, as in the paper's loops. Only where the loop lies within the sweep's
/// angles, and where that is an appreciable part of the loop's height.
void subtract_ripple_from_loop(const gravity::CogSweepResult& sweep, double gear_ratio,
                               joint::Recording& loop);

/// A friction torque less the share of itself by which it was another where it was recorded. Where
/// that may be half or less of the runs' it stays as recorded, and the interval holds the share.
/// @param method of the new interval, with the recorded one's as its value "interval".
statistics::Estimate at_the_runs(const statistics::Estimate& recorded,
                                 const statistics::Estimate& difference,
                                 Code method = "interval.at_the_runs");

/// Static and Coulomb torque as they are at the mean load, place and time of the runs; the bristle
/// stays that of the loops but for the torque's gain there: whether the load stiffens it, or acts
/// beside it, no recording shows.
/// @param friction by which share of itself it is logged as another where the loops were recorded;
/// absent: not known, and nothing is changed.
/// @param gain by which share of itself a change of the torque is logged too large there.
LuGreFit with_friction_of_runs(LuGreFit fit, const std::optional<statistics::Estimate>& friction,
                               const std::optional<statistics::Estimate>& gain);

}  // namespace tribolog::method::hysteresis
