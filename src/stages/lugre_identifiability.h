#pragma once
// What a climbed ladder shows: parameters in their own units, and the singular values behind it.

#include "stages/lugre_fit.h"
#include "stages/lugre_ladder.h"

namespace tribolog {

/// Every LuGre parameter: its estimate, or why there is none.
/// @param peak_speed_rad_s largest motor speed in the loops.
std::vector<LuGreParameter> lugre_parameters(const LuGreClimb& climb, double peak_speed_rad_s);

LuGreIdentifiability lugre_identifiability(const LuGreClimb& climb, double peak_speed_rad_s,
                                           double peak_acceleration_rad_s2);

}  // namespace tribolog
