#include "friction/stribeck.h"

#include <algorithm>

#include "base/parameter_rules.h"
#include "friction/speed_step.h"

namespace tribolog {

ParameterSlots StribeckFriction::Parameters::by_name() {
  return joined(
      {curve.by_name(), ParameterSlots{{"viscous_Nms_rad", "Tw >= 0", &viscous_Nms_rad}}});
}

StribeckFriction::StribeckFriction(const Parameters& parameters)
    : p_(parameters), curve_(parameters.curve) {
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

double StribeckFriction::torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * curve_(speed_rad_s) + p_.viscous_Nms_rad * speed_rad_s;
}

double StribeckFriction::torque_at_rest_Nm(double applied_Nm) const {
  const double most = curve_.parameters().static_Nm;
  return std::clamp(applied_Nm, -most, most);
}

}  // namespace tribolog
