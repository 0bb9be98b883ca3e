#include "friction/threshold_speed.h"

#include <cmath>

#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::friction {

ParameterSlots ThresholdSpeedFriction::Parameters::by_name() {
  return {{"coulomb_Nm", &coulomb_Nm},
          {"static_Nm", &static_Nm},
          {"stribeck_decay_s_rad", &stribeck_decay_s_rad},
          {"viscous_Nms_rad", &viscous_Nms_rad},
          {"threshold_rad_s", &threshold_rad_s, true}};
}

ThresholdSpeedFriction::ThresholdSpeedFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_positive(p_.static_Nm, "static torque", "N·m");
  require_not_negative(p_.stribeck_decay_s_rad, Code{"parameter.stribeck_decay"}, "s/rad");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  require_positive(p_.threshold_rad_s, "threshold speed", "rad/s");
  require_not_above(p_.coulomb_Nm, "Coulomb torque", p_.static_Nm, "static torque", "N·m");
}

double ThresholdSpeedFriction::sliding_Nm(double absolute_speed_rad_s) const {
  return p_.coulomb_Nm +
         (p_.static_Nm - p_.coulomb_Nm) *
             std::exp(-p_.stribeck_decay_s_rad * absolute_speed_rad_s) +
         p_.viscous_Nms_rad * absolute_speed_rad_s;
}

double ThresholdSpeedFriction::torque_Nm(double speed_rad_s) const {
  const double size = std::abs(speed_rad_s);
  if (size < p_.threshold_rad_s) {
    return speed_rad_s / p_.threshold_rad_s * sliding_Nm(p_.threshold_rad_s);
  }
  return std::copysign(sliding_Nm(size), speed_rad_s);
}

}  // namespace tribolog::friction
