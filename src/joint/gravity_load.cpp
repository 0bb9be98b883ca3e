#include "joint/gravity_load.h"

#include <algorithm>
#include <cmath>

#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::joint {

GravityLoad::GravityLoad(double mass_kg, double distance_m, double q_peak_rad, double gravity_m_s2)
    : mass_kg_(mass_kg),
      distance_m_(distance_m),
      q_peak_rad_(q_peak_rad),
      gravity_m_s2_(gravity_m_s2) {
  require_positive(mass_kg, "mass", "kg");
  require_positive(distance_m, Code{"parameter.cog_distance"}, "m");
  require_positive(gravity_m_s2, "gravity", "m/s²");
  if (!std::isfinite(q_peak_rad)) {
    throw Refusal({"gravity_peak.value_not_finite", {{"angle_rad", q_peak_rad}}});
  }
}

double GravityLoad::amplitude_Nm() const { return mass_kg_ * gravity_m_s2_ * distance_m_; }

double GravityLoad::torque_Nm(double q_rad) const {
  return amplitude_Nm() * std::cos(q_rad - q_peak_rad_);
}

double surrogate_mass_kg(double torque_Nm, double gear_ratio, double surrogate_distance_m,
                         double gravity_m_s2, double cos_from_peak) {
  return gear_ratio * torque_Nm / (gravity_m_s2 * surrogate_distance_m * cos_from_peak);
}

bool KnownLoad::loads(Role role) const {
  return roles.empty() || std::find(roles.begin(), roles.end(), role) != roles.end();
}

double KnownLoad::torque_Nm(double angle_sum_rad) const {
  return amplitude_Nm * std::cos(angle_sum_rad + phase_rad);
}

StatedGravity::StatedGravity(double amplitude_Nm, double q_peak_rad, double percent)
    : amplitude_Nm_(amplitude_Nm), q_peak_rad_(q_peak_rad), percent_(percent) {
  require_not_negative(amplitude_Nm, Code{"parameter.known_gravity_amplitude"}, "N·m");
  require_not_negative(percent, Code{"parameter.known_gravity_percent"}, "%");
  if (!std::isfinite(q_peak_rad)) {
    throw Refusal({"gravity_peak.known_value_not_finite", {{"angle_rad", q_peak_rad}}});
  }
}

}  // namespace tribolog::joint
