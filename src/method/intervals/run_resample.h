#pragma once
// Resampling the runs of constant speed: blocks within each plateau.

#include <vector>

#include "method/viscous/viscous_curves.h"
#include "statistics/random_stream.h"

namespace tribolog::bootstrap {

/// What one draw of blocks does to the mean torque of each run [N·m]; zero where a run has no
/// blocks and no interval.
std::vector<double> resample_runs(RandomStream& random, const ViscousCurvesResult& curves);

}  // namespace tribolog::bootstrap
