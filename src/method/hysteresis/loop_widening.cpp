#include "method/hysteresis/loop_widening.h"

#include <algorithm>
#include <cmath>

namespace tribolog::method::hysteresis {

void subtract_ripple_from_loop(const gravity::CogSweepResult& sweep, double gear_ratio,
                               joint::Recording& loop) {
  constexpr double noticeable = 0.002;
  if (!sweep.found || sweep.ripple.lines.empty() || loop.torque_Nm.size() != loop.size() ||
      loop.size() < 2) {
    return;
  }
  const auto [low, high] = std::minmax_element(loop.q_rad.begin(), loop.q_rad.end());
  if (*low < sweep.lowest_rad || *high > sweep.highest_rad) return;
  std::vector<double> ripple;
  ripple.reserve(loop.size());
  double mean = 0;
  for (const double q : loop.q_rad) {
    ripple.push_back(sweep.ripple.torque_Nm(gear_ratio * q));
    mean += ripple.back() / static_cast<double>(loop.size());
  }
  const auto [least, most] = std::minmax_element(ripple.begin(), ripple.end());
  const auto [lowest, highest] = std::minmax_element(loop.torque_Nm.begin(), loop.torque_Nm.end());
  if (*most - *least < noticeable * (*highest - *lowest)) return;
  for (std::size_t i = 0; i < loop.size(); ++i) loop.torque_Nm[i] -= ripple[i] - mean;
}

statistics::Estimate at_the_runs(const statistics::Estimate& recorded,
                                 const statistics::Estimate& difference, Code method) {
  constexpr double least_share = 0.5;
  if (!(1 + difference.low > least_share)) {  // too little is known of the runs' to refer to them
    const double most = std::max(std::abs(difference.low), std::abs(difference.high));
    return statistics::symmetric_estimate(recorded.value,
                                          std::hypot(recorded.half_width(), recorded.value * most),
                                          {method, {{"interval", recorded.method}}});
  }
  const double factor = 1 + difference.value;
  const double value = recorded.value / factor;
  return statistics::symmetric_estimate(
      value, std::hypot(recorded.half_width() / factor, value * difference.half_width() / factor),
      {method, {{"interval", recorded.method}}});
}

LuGreFit with_friction_of_runs(LuGreFit fit, const std::optional<statistics::Estimate>& friction,
                               const std::optional<statistics::Estimate>& gain) {
  for (LuGreParameter& parameter : fit.parameters) {
    if (!parameter.estimate) continue;
    switch (parameter.name) {
      case LuGreParameterName::static_torque:
      case LuGreParameterName::coulomb_torque:
        if (friction) parameter.estimate = at_the_runs(*parameter.estimate, *friction);
        break;
      case LuGreParameterName::bristle_stiffness:
      case LuGreParameterName::bristle_damping:
      case LuGreParameterName::inertia:
        if (gain) {
          parameter.estimate = at_the_runs(*parameter.estimate, *gain, "interval.at_the_gain");
        }
        break;
      default:
        break;
    }
  }
  return fit;
}

}  // namespace tribolog::method::hysteresis
