#pragma once
// What a climbed ladder shows: parameters in their own units, and the singular values behind them.

#include "method/hysteresis/lugre_fit.h"
#include "method/hysteresis/lugre_ladder.h"

namespace tribolog::method::hysteresis {

/// All: the estimate, or why there is none.
/// @param peak_speed_rad_s largest motor speed in the loops.
/// @param effects in the climb's covariance.
std::vector<LuGreParameter> read_lugre_parameters(const LuGreClimb& climb,
                                                  const LoopEffects& effects,
                                                  double peak_speed_rad_s);

LuGreIdentifiability lugre_identifiability(const LuGreClimb& climb, double peak_speed_rad_s,
                                           double peak_acceleration_rad_s2);

}  // namespace tribolog::method::hysteresis
