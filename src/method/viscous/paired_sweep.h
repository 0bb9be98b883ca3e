#pragma once
// A sweep of varying speed in both directions, cut into equal bins of the angle: in each bin one
// run up and one run down, whose half difference is friction and whose mean is gravity.

#include <vector>

#include "method/gravity/cog_sweep.h"
#include "method/viscous/viscous_curves.h"

namespace tribolog::method::viscous {

/// Two runs (falling, rising) for each angle bin that both directions cross, partners of each
/// other. Inertia and offset identified by the sweep are subtracted from the torque.
std::vector<ConstantSpeedRun> pair_sweep_by_angle(const motion::Sweep& sweep,
                                                  const gravity::CogSweepResult& found,
                                                  double gear_ratio, double q_peak_rad);

/// For a joint without gravity: the sweep's samples binned by speed, whatever the angle; one run
/// for each direction of each bin. Neither offset nor gravity is subtracted.
std::vector<ConstantSpeedRun> bin_sweep_by_speed(const motion::Sweep& sweep,
                                                 const gravity::CogSweepResult& found,
                                                 double gear_ratio);

}  // namespace tribolog::method::viscous
