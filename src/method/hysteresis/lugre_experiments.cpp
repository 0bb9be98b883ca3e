#include "method/hysteresis/lugre_experiments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "method/hysteresis/lugre_ladder.h"

namespace tribolog::method::hysteresis {
namespace {

/// By how much a parameter's torque has to grow against the scatter to be shown, with a margin.
double growth_needed(const LuGreParameter& p, const LuGreFit& fit) {
  constexpr double margin = 2;
  constexpr double t_factor = 2;
  constexpr double most = 100;
  double growth = 3;
  if (p.relative_error && std::isfinite(*p.relative_error)) {
    growth = std::max(growth, margin * t_factor * *p.relative_error / widest_shown);
  }
  if (p.effect_Nm && *p.effect_Nm > 0) {
    growth = std::max(growth, margin * smallest_effect * fit.height_Nm / *p.effect_Nm);
  }
  return std::min(growth, most);
}

std::string past_stribeck(const LuGreFit& fit, double n, const std::optional<double>& stribeck) {
  const std::string here =
      fmt::format("these loops reach {:.2g} rad/s at the motor", fit.peak_speed_rad_s);
  if (!stribeck) {
    return fmt::format(
        "an oscillation whose peak motor speed 2π f n a passes the Stribeck velocity, beside this "
        "one ({}); runs at constant speed would tell that velocity",
        here);
  }
  const double peak = 2 * *stribeck;
  const double fast_Hz = 5 * fit.frequency_Hz;
  const auto amplitude = [&](double f) { return peak / (2 * std::numbers::pi * f * n); };
  return fmt::format(
      "an oscillation beside this one whose peak motor speed passes the Stribeck velocity of the "
      "runs at constant speed, {:.2g} rad/s, twofold ({}): {:.2g} Hz with {:.2g} rad at the joint, "
      "or {:.2g} Hz with {:.2g} rad",
      *stribeck, here, fit.frequency_Hz, amplitude(fit.frequency_Hz), fast_Hz, amplitude(fast_Hz));
}

std::string experiment_for(const LuGreParameter& p, const LuGreFit& fit, double n,
                           const std::optional<double>& stribeck) {
  const double amplitude = fit.motor_amplitude_rad / n;
  const double growth = growth_needed(p, fit);
  if (p.name == "coulomb_Nm" || p.name == "stribeck_speed_rad_s" ||
      p.name == "speed_weakening_Nms2_rad2") {
    return past_stribeck(fit, n, stribeck);
  }
  if (p.name == "static_Nm" || p.name == "bristle_stiffness_Nm_rad") {
    return fmt::format(
        "an oscillation of larger amplitude, {:.2g} rad at the joint and more, until the ends of "
        "the loop flatten "
        "(it was {:.2g} rad)",
        3 * amplitude, amplitude);
  }
  if (p.name == "inertia_kgm2") {
    return fmt::format("another oscillation of the same amplitude at {:.2g} Hz",
                       fit.frequency_Hz * std::max(2.0, std::sqrt(growth)));
  }
  const std::string second = fmt::format("another oscillation of the same amplitude at {:.2g} Hz",
                                         fit.frequency_Hz * growth);
  if (p.name != "viscous_Nms_rad") return second;
  constexpr double most_by_frequency = 10;
  const std::string runs = "runs at constant speed";
  return growth > most_by_frequency ? runs : runs + ", or " + second;
}

}  // namespace

LuGreFit with_experiments(LuGreFit fit, double gear_ratio,
                          const std::optional<double>& stribeck_speed_rad_s) {
  for (LuGreParameter& p : fit.parameters) {
    p.experiment = p.estimate ? "" : experiment_for(p, fit, gear_ratio, stribeck_speed_rad_s);
  }
  return fit;
}

}  // namespace tribolog::method::hysteresis
