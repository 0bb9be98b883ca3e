#include "joint/known_load.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "base/parameter_rules.h"

namespace tribolog {

bool KnownLoad::loads(Role role) const {
  return roles.empty() || std::find(roles.begin(), roles.end(), role) != roles.end();
}

double KnownLoad::torque_Nm(double angle_sum_rad) const {
  return amplitude_Nm * std::cos(angle_sum_rad + phase_rad);
}

StatedGravity::StatedGravity(double amplitude_Nm, double q_peak_rad)
    : amplitude_Nm_(amplitude_Nm), q_peak_rad_(q_peak_rad) {
  require_positive(amplitude_Nm, "amplitude of the known gravity", "N·m");
  if (!std::isfinite(q_peak_rad)) {
    throw std::invalid_argument(
        fmt::format("angle of the known gravity peak {} is not finite", q_peak_rad));
  }
}

}  // namespace tribolog
