#include "method/hysteresis/lugre_experiments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "method/hysteresis/lugre_ladder.h"

namespace tribolog::method::hysteresis {
namespace {

/// Factor by which a parameter's torque has to grow relative to the scatter to be shown, with a
/// margin.
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

Statement past_stribeck(const LuGreFit& fit, double n, const std::optional<double>& stribeck) {
  if (!stribeck) {
    return {"lugre_experiment.past_unknown_stribeck_speed",
            {{"peak_speed_rad_s", fit.peak_speed_rad_s}}};
  }
  const double peak = 2 * *stribeck;
  const double fast_Hz = 5 * fit.frequency_Hz;
  const auto amplitude = [&](double f) { return peak / (2 * std::numbers::pi * f * n); };
  return {"lugre_experiment.past_stribeck_speed",
          {{"stribeck_speed_rad_s", *stribeck},
           {"peak_speed_rad_s", fit.peak_speed_rad_s},
           {"frequency_Hz", fit.frequency_Hz},
           {"amplitude_rad", amplitude(fit.frequency_Hz)},
           {"fast_frequency_Hz", fast_Hz},
           {"fast_amplitude_rad", amplitude(fast_Hz)}}};
}

Statement experiment_for(const LuGreParameter& p, const LuGreFit& fit, double n,
                         const std::optional<double>& stribeck) {
  const double amplitude = fit.motor_amplitude_rad / n;
  const double growth = growth_needed(p, fit);
  if (p.name == LuGreParameterName::coulomb_torque ||
      p.name == LuGreParameterName::stribeck_speed ||
      p.name == LuGreParameterName::speed_weakening) {
    return past_stribeck(fit, n, stribeck);
  }
  if (p.name == LuGreParameterName::static_torque ||
      p.name == LuGreParameterName::bristle_stiffness) {
    return {"lugre_experiment.larger_amplitude",
            {{"larger_rad", 3 * amplitude}, {"amplitude_rad", amplitude}}};
  }
  if (p.name == LuGreParameterName::inertia) {
    return {"lugre_experiment.other_frequency",
            {{"frequency_Hz", fit.frequency_Hz * std::max(2.0, std::sqrt(growth))}}};
  }
  const double higher_Hz = fit.frequency_Hz * growth;
  if (p.name != LuGreParameterName::viscous) {
    return {"lugre_experiment.other_frequency", {{"frequency_Hz", higher_Hz}}};
  }
  constexpr double most_by_frequency = 10;
  if (growth > most_by_frequency) return {"lugre_experiment.runs"};
  return {"lugre_experiment.runs_or_other_frequency", {{"frequency_Hz", higher_Hz}}};
}

}  // namespace

LuGreFit with_experiments(LuGreFit fit, double gear_ratio,
                          const std::optional<double>& stribeck_speed_rad_s) {
  for (LuGreParameter& p : fit.parameters) {
    p.experiment =
        p.estimate ? Statement{} : experiment_for(p, fit, gear_ratio, stribeck_speed_rad_s);
  }
  return fit;
}

}  // namespace tribolog::method::hysteresis
