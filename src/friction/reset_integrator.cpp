#include "friction/reset_integrator.h"

#include <algorithm>
#include <cmath>

#include "parameter_rules.h"

namespace tribolog {

ParameterSlots ResetIntegratorFriction::Parameters::by_name() {
  return {{"stiffness_Nm_rad", "s0 > 0", &stiffness_Nm_rad},
          {"damping_Nms_rad", "s1 >= 0", &damping_Nms_rad},
          {"largest_deflection_rad", "z0 > 0; Coulomb torque is s0 z0", &largest_deflection_rad},
          {"stiction_gain", "a >= 0; break-away torque is (1 + a) s0 z0", &stiction_gain},
          {"viscous_Nms_rad", ">= 0", &viscous_Nms_rad}};
}

ResetIntegratorFriction::ResetIntegratorFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_not_negative(p_.damping_Nms_rad, "damping", "N·m·s/rad");
  require_positive(p_.largest_deflection_rad, "largest deflection", "rad");
  require_not_negative(p_.stiction_gain, "stiction gain", "");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

bool ResetIntegratorFriction::is_sliding(double z_rad, double speed_rad_s) const {
  const double bound = p_.largest_deflection_rad;
  return (speed_rad_s > 0 && z_rad >= bound) || (speed_rad_s < 0 && z_rad <= -bound);
}

void ResetIntegratorFriction::rates(std::span<const double> state, double speed_rad_s,
                                    std::span<double> rates) const {
  rates[0] = is_sliding(state[0], speed_rad_s) ? 0.0 : speed_rad_s;
}

double ResetIntegratorFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const double z = state[0];
  const bool is_bonded = std::abs(z) < p_.largest_deflection_rad;
  const double gain = is_bonded ? 1 + p_.stiction_gain : 1.0;
  const double rate = is_sliding(z, speed_rad_s) ? 0.0 : speed_rad_s;
  return gain * p_.stiffness_Nm_rad * z + p_.damping_Nms_rad * rate +
         p_.viscous_Nms_rad * speed_rad_s;
}

double ResetIntegratorFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * p_.stiffness_Nm_rad * p_.largest_deflection_rad + p_.viscous_Nms_rad * speed_rad_s;
}

void ResetIntegratorFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double bound = p_.largest_deflection_rad;
  state[0] = std::clamp(state[0] + step.path_rad(), -bound, bound);
}

void ResetIntegratorFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.largest_deflection_rad;
}

void ResetIntegratorFriction::event_values(std::span<const double> state, double /*speed_rad_s*/,
                                           std::span<double> values) const {
  values[0] = std::abs(state[0]) - p_.largest_deflection_rad;
}

}  // namespace tribolog
