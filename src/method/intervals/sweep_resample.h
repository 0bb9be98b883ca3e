#pragma once
// Resampling sweeps and runs: blocks of neighbours within their strokes and plateaus.

#include <vector>

#include "method/gravity/cog_sweep.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {

/// Shift of a sweep's results by one draw of its blocks. Zero where the sweep has found nothing.
gravity::SweepShift resample_sweep(statistics::RandomStream& random,
                                   const gravity::CogSweep& sweep);

/// The same for the precise sweep, which depends on the rough one: with the gravity and the twist
/// drawn there, and its ripple at any phase.
gravity::SweepShift resample_precise_sweep(statistics::RandomStream& random,
                                           const gravity::CogSweep& precise,
                                           const gravity::Ripple& ripple,
                                           const gravity::SweepShift& rough);

// Resampling the runs of constant speed: blocks within each plateau.

/// Shift of each run's mean torque [N·m] by one draw of blocks; zero where a run has no blocks and
/// no interval.
std::vector<double> resample_runs(statistics::RandomStream& random,
                                  const viscous::ViscousCurves& curves);

}  // namespace tribolog::method::intervals
