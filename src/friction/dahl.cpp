#include "friction/dahl.h"

#include <algorithm>
#include <cmath>

#include "base/requirements.h"

namespace tribolog::friction {
ParameterSlots DahlFriction::Parameters::by_name() {
  return {{"stiffness_Nm_rad", &stiffness_Nm_rad},
          {"coulomb_Nm", &coulomb_Nm},
          {"exponent", &exponent, true},
          {"viscous_Nms_rad", &viscous_Nms_rad}};
}

DahlFriction::DahlFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_not_negative(p_.exponent, "Dahl's exponent", "");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

void DahlFriction::rates(std::span<const double> state, double speed_rad_s,
                         std::span<double> rates) const {
  const double left = 1 - direction_of(speed_rad_s) * state[0] / p_.coulomb_Nm;
  const double slope = std::pow(std::abs(left), p_.exponent) * direction_of(left);
  rates[0] = p_.stiffness_Nm_rad * slope * speed_rad_s;
}

double DahlFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  return state[0] + p_.viscous_Nms_rad * speed_rad_s;
}

double DahlFriction::steady_torque_Nm(double speed_rad_s) const {
  return direction_of(speed_rad_s) * p_.coulomb_Nm + p_.viscous_Nms_rad * speed_rad_s;
}

// With u = 1 - sgn(w) T/Tc and y = s0 |way| / Tc the model reads du/dy = -u^i.
void DahlFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const double u0 = 1 - direction * state[0] / p_.coulomb_Nm;
  const double y = p_.stiffness_Nm_rad * std::abs(step.path_rad()) / p_.coulomb_Nm;
  const double size = std::abs(u0);
  double end = 0;
  if (p_.exponent == 1.0) {
    end = size * std::exp(-y);
  } else if (size > 0) {
    const double k = 1 - p_.exponent;
    const double power = std::pow(size, k) - k * y;
    end = power > 0 ? std::pow(power, 1 / k) : 0.0;
  }
  state[0] = direction * p_.coulomb_Nm * (1 - std::copysign(end, u0));
}

void DahlFriction::state_scales(std::span<double> scales) const { scales[0] = p_.coulomb_Nm; }

}  // namespace tribolog::friction
