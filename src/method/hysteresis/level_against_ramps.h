#pragma once
// The level that hysteresis loops flatten at, against torque ramps that made the joint slide or
// not.

#include "method/hysteresis/break_away.h"
#include "method/hysteresis/lugre_fit.h"

namespace tribolog {

/// Takes the static torque, and what was read relative to it, out of what the fit shows, with the
/// reason, where ramps show that the joint holds more: its loops then creep, and what flattens them
/// is no break-away. What the fit keeps for resampling (LuGreFit::linearised) still has them.
LuGreFit against_ramps(LuGreFit fit, const BreakAwayResult& ramps);

}  // namespace tribolog
