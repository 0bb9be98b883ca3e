#pragma once
// The next experiment for each LuGre parameter that the recorded loops did not show.

#include <optional>

#include "method/hysteresis/lugre_fit.h"

namespace tribolog::method::hysteresis {

/// Fills LuGreParameter::experiment of parameters that are not shown, with amplitudes and
/// frequencies.
/// @param stribeck_speed_rad_s from runs at constant speed (motor side), where one was fitted:
/// without it the plan for Tc and ws contains no number.
LuGreFit with_experiments(LuGreFit fit, double gear_ratio,
                          const std::optional<double>& stribeck_speed_rad_s);

}  // namespace tribolog::method::hysteresis
