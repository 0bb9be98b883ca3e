#include "friction/lugre.h"

#include <cmath>

#include "base/requirements.h"
#include "friction/exponential_step.h"
#include "friction/model_entry.h"

namespace tribolog::friction {

ParameterSlots LuGreFriction::Parameters::by_name() {
  return {{"bristle_stiffness_Nm_rad", &bristle_stiffness_Nm_rad},
          {"bristle_damping_Nms_rad", &bristle_damping_Nms_rad},
          {"viscous_Nms_rad", &viscous_Nms_rad},
          {"coulomb_Nm", &coulomb_Nm},
          {"static_Nm", &static_Nm},
          {"stribeck_speed_rad_s", &stribeck_speed_rad_s},
          {"stribeck_power", &stribeck_power, true},
          {"damping_speed_rad_s", &damping_speed_rad_s, true}};
}

LuGreFriction::LuGreFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.bristle_stiffness_Nm_rad, "bristle stiffness", "N·m/rad");
  require_not_negative(p_.bristle_damping_Nms_rad, "bristle damping", "N·m·s/rad");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_positive(p_.static_Nm, "static torque", "N·m");
  require_positive(p_.stribeck_speed_rad_s, "Stribeck velocity", "rad/s");
  require_positive(p_.stribeck_power, "Stribeck power", "");
  require_not_negative(p_.damping_speed_rad_s, "damping speed", "rad/s");
  require_not_above(p_.coulomb_Nm, "Coulomb torque", p_.static_Nm, "static torque", "N·m");
}

double LuGreFriction::steady_deflection_rad(double speed_rad_s) const {
  const double x = std::abs(speed_rad_s) / p_.stribeck_speed_rad_s;
  const double exponent = p_.stribeck_power == 2.0 ? x * x : std::pow(x, p_.stribeck_power);
  return (p_.coulomb_Nm + (p_.static_Nm - p_.coulomb_Nm) * std::exp(-exponent)) /
         p_.bristle_stiffness_Nm_rad;
}

double LuGreFriction::deflection_rate_rad_s(double z_rad, double speed_rad_s) const {
  return speed_rad_s - std::abs(speed_rad_s) * z_rad / steady_deflection_rad(speed_rad_s);
}

double LuGreFriction::damping_Nms_rad(double speed_rad_s) const {
  if (p_.damping_speed_rad_s == 0) return p_.bristle_damping_Nms_rad;
  const double x = speed_rad_s / p_.damping_speed_rad_s;
  return p_.bristle_damping_Nms_rad * std::exp(-x * x);
}

double LuGreFriction::torque_Nm(double z_rad, double dz_rad_s, double speed_rad_s) const {
  return p_.bristle_stiffness_Nm_rad * z_rad + damping_Nms_rad(speed_rad_s) * dz_rad_s +
         p_.viscous_Nms_rad * speed_rad_s;
}

double LuGreFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * p_.bristle_stiffness_Nm_rad * steady_deflection_rad(speed_rad_s) +
         p_.viscous_Nms_rad * speed_rad_s;
}

void LuGreFriction::rates(std::span<const double> state, double speed_rad_s,
                          std::span<double> rates) const {
  rates[0] = deflection_rate_rad_s(state[0], speed_rad_s);
}

double LuGreFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  return torque_Nm(state[0], deflection_rate_rad_s(state[0], speed_rad_s), speed_rad_s);
}

void LuGreFriction::advance(std::span<double> state, const SpeedStep& step) const {
  state[0] = exponential_step(step.start_rad_s, step.middle_rad_s, step.end_rad_s,
                              steady_deflection_rad(step.start_rad_s),
                              steady_deflection_rad(step.middle_rad_s),
                              steady_deflection_rad(step.end_rad_s), step.duration_s, state[0]);
}

void LuGreFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.coulomb_Nm / p_.bristle_stiffness_Nm_rad;
}

namespace {

LuGreFriction::Parameters lugre(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.damping_Nms_rad, c.viscous_Nms_rad,
          c.coulomb_Nm,       c.static_Nm,       c.stribeck_speed_rad_s};
}

}  // namespace

FrictionModelEntry lugre_model() {
  return model<LuGreFriction>(
      {.break_away = true, .stribeck = true, .lag = true, .presliding = true, .drifts = true},
      lugre);
}

}  // namespace tribolog::friction
