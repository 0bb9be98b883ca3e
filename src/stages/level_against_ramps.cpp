#include "stages/level_against_ramps.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace tribolog {

LuGreFit against_ramps(LuGreFit fit, const BreakAwayResult& ramps) {
  const auto level = fit.shown("static_Nm");
  if (!level || ramps.ramps.empty()) return fit;
  // Gravity that was not taken off helps one direction by what it hinders the other: the smaller
  // of the two is held in any case.
  double rising = 0;
  double falling = 0;
  for (const BreakAwayRamp& ramp : ramps.ramps) {
    double& held = ramp.is_rising ? rising : falling;
    held = std::max(held, ramp.friction_Nm);
  }
  const double held = rising > 0 && falling > 0 ? std::min(rising, falling) : 0;
  if (!(level->high < held)) return fit;
  for (LuGreParameter& p : fit.parameters) {
    if (p.name != "static_Nm") continue;
    p.estimate.reset();
    p.why_not = fmt::format(
        "the loops flatten at {:.3g} N·m, but ramps of the torque show that the joint holds "
        "{:.3g} N·m without sliding: the loops creep, and their level is no break-away torque",
        level->value, held);
    p.experiment = "the ramps themselves show it, where they end in sliding";
    fit.reason += (fit.reason.empty() ? "" : "; ") + p.why_not;
  }
  return fit;
}

}  // namespace tribolog
