#pragma once
// What a climbed ladder shows: parameters in their own units, and the singular values behind them.

#include "method/hysteresis/lugre_fit.h"
#include "method/hysteresis/lugre_ladder.h"

namespace tribolog::method::hysteresis {

struct LuGreReadings {
  std::vector<LuGreParameter> parameters;  ///< All: the estimate, or why there is none.
  std::vector<LuGreParameterName> shown;   ///< Those with an estimate,
  std::vector<statistics::LinearisedReading> readings;  ///< and how they follow from the fit.
};

/// @param peak_speed_rad_s largest motor speed in the loops.
LuGreReadings read_lugre_parameters(const LuGreClimb& climb, double peak_speed_rad_s);

LuGreIdentifiability lugre_identifiability(const LuGreClimb& climb, double peak_speed_rad_s,
                                           double peak_acceleration_rad_s2);

}  // namespace tribolog::method::hysteresis
