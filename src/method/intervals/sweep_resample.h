#pragma once
// Resampling sweeps and runs: blocks of neighbours within their strokes and plateaus.

#include <vector>

#include "method/gravity/cog_sweep.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {

/// What one draw of a sweep's blocks does to its results. Zero where the sweep has found nothing.
gravity::SweepShift resample_sweep(statistics::RandomStream& random,
                                   const gravity::CogSweep& sweep);

/// The precise sweep leans on the rough one: with the gravity and the twist drawn there, and its
/// ripple at any phase.
gravity::SweepShift resample_precise_sweep(statistics::RandomStream& random,
                                           const gravity::CogSweep& precise,
                                           const gravity::Ripple& ripple,
                                           const gravity::SweepShift& rough);

// Resampling the runs of constant speed: blocks within each plateau.

/// What one draw of blocks does to the mean torque of each run [N·m]; zero where a run has no
/// blocks and no interval.
std::vector<double> resample_runs(statistics::RandomStream& random,
                                  const viscous::ViscousCurves& curves);

}  // namespace tribolog::method::intervals
