#include "friction/hess_soom.h"

#include <cmath>

#include "base/requirements.h"
#include "friction/exponential_step.h"

namespace tribolog::friction {

ParameterSlots HessSoomFriction::Parameters::by_name() {
  return {{"coulomb_Nm", &coulomb_Nm},
          {"static_Nm", &static_Nm},
          {"stribeck_speed_rad_s", &stribeck_speed_rad_s},
          {"viscous_Nms_rad", &viscous_Nms_rad},
          {"lag_s", &lag_s}};
}

HessSoomFriction::HessSoomFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_positive(p_.static_Nm, "static torque", "N·m");
  require_positive(p_.stribeck_speed_rad_s, "Stribeck velocity", "rad/s");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  require_positive(p_.lag_s, "frictional lag", "s");
  require_not_above(p_.coulomb_Nm, "Coulomb torque", p_.static_Nm, "static torque", "N·m");
}

void HessSoomFriction::rates(std::span<const double> state, double speed_rad_s,
                             std::span<double> rates) const {
  rates[0] = (std::abs(speed_rad_s) - state[0]) / p_.lag_s;
}

double HessSoomFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  const double x = state[0] / p_.stribeck_speed_rad_s;
  return sign * (p_.coulomb_Nm + (p_.static_Nm - p_.coulomb_Nm) / (1 + x * x)) +
         p_.viscous_Nms_rad * speed_rad_s;
}

double HessSoomFriction::steady_torque_Nm(double speed_rad_s) const {
  const double settled = std::abs(speed_rad_s);
  return torque_Nm({&settled, 1}, speed_rad_s);
}

void HessSoomFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double rate = 1 / p_.lag_s;
  state[0] = relaxed(relaxation_shape<double>(rate, rate, rate, std::abs(step.start_rad_s),
                                              std::abs(step.middle_rad_s), std::abs(step.end_rad_s),
                                              step.duration_s),
                     state[0]);
}

void HessSoomFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.stribeck_speed_rad_s;
}

}  // namespace tribolog::friction
