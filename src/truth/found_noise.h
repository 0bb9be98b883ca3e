#pragma once
// The noise of a dataset as its recordings show it: what a repetition of the measurement would
// have.

#include <vector>

#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "simulate/scenario.h"

namespace tribolog::truth {

/// Standard deviation of the white part of a torque [N·m], from third differences of neighbouring
/// samples (statistics/white_noise.h). The smaller one of their mean square and their median: jumps
/// of friction at a reversal weigh on the first, steps of the torque on the second. 0 with fewer
/// than four samples.
double white_torque_Nm(const std::vector<double>& torque_Nm);

/// Torque ripple periodic in the motor's angle, from what the rough sweep's fit leaves: the
/// strongest lines of a search as fine as its samples allow (method/gravity/ripple_spectrum.h), up
/// to four, so enlarged that together they make the standard deviation CogSweepResult::ripple_Nm.
/// Periods of which the sweep holds fewer than three are none: they cannot be told from gravity.
/// Empty where no line carries a tenth of the ripple's variance. Phases are as found.
std::vector<simulate::Noise::Ripple> ripple_of(const method::gravity::CogSweepResult& rough,
                                               double gear_ratio);

}  // namespace tribolog::truth
