#pragma once
// Internal to the cross-checks: gravity from the mean of both directions at equal angle.

#include <optional>

#include "method/selection/gravity_by_other_ways.h"

namespace tribolog {

/// From a sweep of both directions; absent otherwise.
std::optional<GravityByOtherWay> gravity_of_sweep_directions(const CogSweepResult& rough,
                                                             double gear_ratio);

/// From pairs of runs of opposite direction; absent with fewer than three pairs.
std::optional<GravityByOtherWay> gravity_of_run_directions(const ViscousCurvesResult& curves);

}  // namespace tribolog
