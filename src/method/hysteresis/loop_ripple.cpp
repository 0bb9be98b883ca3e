#include "method/hysteresis/loop_ripple.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace tribolog::method::hysteresis {

LuGreFit with_ripple_of_loops(LuGreFit fit, const gravity::Ripple& ripple) {
  const double x = fit.motor_amplitude_rad;
  const double w = 2 * std::numbers::pi * fit.frequency_Hz;
  if (ripple.lines.empty() || !(x > 0)) return fit;
  std::vector<double> heights;
  for (const gravity::RippleLine& line : ripple.lines) {
    const double phase = std::min(line.periods_per_turn * x, std::numbers::pi / 2);
    heights.push_back(line.amplitude_Nm * std::sin(phase));
  }
  const double height_Nm = gravity::random_phase_half_width(heights, 0);
  const auto by = [&](LuGreParameterName name) {
    switch (name) {
      case LuGreParameterName::static_torque:
      case LuGreParameterName::coulomb_torque:
        return height_Nm;
      case LuGreParameterName::bristle_stiffness:
        return height_Nm / x;
      case LuGreParameterName::inertia:
        return w > 0 ? height_Nm / (x * w * w) : 0.0;
      default:
        return 0.0;
    }
  };
  constexpr double noticeable = 1.01;
  for (LuGreParameter& parameter : fit.parameters) {
    if (!parameter.estimate) continue;
    statistics::Estimate& e = *parameter.estimate;
    const double half_width = std::hypot(e.half_width(), by(parameter.name));
    if (!(half_width > noticeable * e.half_width())) continue;
    e = statistics::symmetric_estimate(
        e.value, half_width, {"interval.widened_by_ripple_of_loops", {{"interval", e.method}}});
  }
  return fit;
}

}  // namespace tribolog::method::hysteresis
