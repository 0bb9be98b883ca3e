#include "method/hysteresis/level_against_ramps.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace tribolog {
namespace {

/// Friction that the joint holds in one direction, beyond the scatter of its ramps. Of single
/// readings the largest would be their noise.
double surely_held(const BreakAwayResult& ramps, bool is_rising) {
  const std::optional<Estimate>& mean = is_rising ? ramps.rising_Nm : ramps.falling_Nm;
  double held = mean ? mean->low : 0;
  for (const BreakAwayRamp& ramp : ramps.ramps) {
    const bool is_in_mean = mean && ramp.broke_away;
    if (ramp.is_rising == is_rising && !is_in_mean) held = std::max(held, ramp.friction_Nm);
  }
  return held;
}

/// How friction falls with speed is read relative to the level.
bool rests_on_level(const std::string& name) {
  return name == "coulomb_Nm" || name == "stribeck_speed_rad_s" ||
         name == "speed_weakening_Nms2_rad2";
}

void withdraw(LuGreParameter& parameter, std::string why_not, std::string experiment) {
  parameter.estimate.reset();
  parameter.why_not = std::move(why_not);
  parameter.experiment = std::move(experiment);
}

}  // namespace

LuGreFit against_ramps(LuGreFit fit, const BreakAwayResult& ramps) {
  const auto level = fit.shown("static_Nm");
  if (!level || ramps.ramps.empty()) return fit;
  // Gravity that was not taken off helps one direction by what it hinders the other: the smaller
  // of the two is held in any case.
  const double rising = surely_held(ramps, true);
  const double falling = surely_held(ramps, false);
  const double held = rising > 0 && falling > 0 ? std::min(rising, falling) : 0;
  if (!(level->high < held)) return fit;
  const std::string contradiction = fmt::format(
      "the loops flatten at {:.3g} N·m, but ramps of the torque show that the joint holds "
      "{:.3g} N·m without sliding: the loops creep, and their level is no break-away torque",
      level->value, held);
  for (LuGreParameter& p : fit.parameters) {
    if (p.name == "static_Nm") {
      withdraw(p, contradiction, "the ramps themselves show it, where they end in sliding");
    } else if (p.estimate && rests_on_level(p.name)) {
      withdraw(p, "it was read from the way friction falls from a level that ramps contradict",
               "runs at constant speed");
    }
  }
  fit.reason += (fit.reason.empty() ? "" : "; ") + contradiction;
  return fit;
}

}  // namespace tribolog
