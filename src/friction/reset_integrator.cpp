#include "friction/reset_integrator.h"

#include <cmath>

#include "base/requirements.h"

namespace tribolog::friction {
namespace {

enum ResetMember : std::size_t { bristle_deflection, slip_direction };

}  // namespace

ParameterSlots ResetIntegratorFriction::Parameters::by_name() {
  return {{"stiffness_Nm_rad", &stiffness_Nm_rad},
          {"damping_Nms_rad", &damping_Nms_rad},
          {"largest_deflection_rad", &largest_deflection_rad},
          {"stiction_gain", &stiction_gain},
          {"viscous_Nms_rad", &viscous_Nms_rad}};
}

ResetIntegratorFriction::ResetIntegratorFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_not_negative(p_.damping_Nms_rad, "damping", "N·m·s/rad");
  require_positive(p_.largest_deflection_rad, "largest deflection", "rad");
  require_not_negative(p_.stiction_gain, "stiction gain", "");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

void ResetIntegratorFriction::rates(std::span<const double> state, double speed_rad_s,
                                    std::span<double> rates) const {
  rates[bristle_deflection] = state[slip_direction] == 0.0 ? speed_rad_s : 0.0;
  rates[slip_direction] = 0;
}

void ResetIntegratorFriction::settle(std::span<double> state, double speed_rad_s) const {
  const double direction = direction_of(speed_rad_s);
  if (state[slip_direction] != direction) state[slip_direction] = 0;
  const double bound = p_.largest_deflection_rad;
  if (direction * state[bristle_deflection] < bound || direction == 0.0) return;
  state[bristle_deflection] = direction * bound;
  state[slip_direction] = direction;
}

double ResetIntegratorFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const bool is_bonded = std::abs(state[bristle_deflection]) < p_.largest_deflection_rad;
  const double gain = is_bonded ? 1 + p_.stiction_gain : 1.0;
  const double rate = state[slip_direction] == 0.0 ? speed_rad_s : 0.0;
  return gain * p_.stiffness_Nm_rad * state[bristle_deflection] + p_.damping_Nms_rad * rate +
         p_.viscous_Nms_rad * speed_rad_s;
}

double ResetIntegratorFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * p_.stiffness_Nm_rad * p_.largest_deflection_rad + p_.viscous_Nms_rad * speed_rad_s;
}

void ResetIntegratorFriction::advance(std::span<double> state, const SpeedStep& step) const {
  state[bristle_deflection] += step.path_rad();
  settle(state, step.direction());
}

void ResetIntegratorFriction::state_scales(std::span<double> scales) const {
  scales[bristle_deflection] = p_.largest_deflection_rad;
  scales[slip_direction] = 1;
}

void ResetIntegratorFriction::event_values(std::span<const double> state, double /*speed_rad_s*/,
                                           std::span<double> values) const {
  const bool is_bonded = state[slip_direction] == 0.0;
  values[0] = is_bonded ? std::abs(state[bristle_deflection]) - p_.largest_deflection_rad : 1.0;
}

}  // namespace tribolog::friction
