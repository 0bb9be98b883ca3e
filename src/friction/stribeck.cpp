#include "friction/stribeck.h"

#include <algorithm>

#include "parameter_rules.h"

#include "friction/speed_step.h"

namespace tribolog {

StribeckFriction::StribeckFriction(const Parameters& parameters)
    : curve_(parameters.curve), viscous_Nms_rad_(parameters.viscous_Nms_rad) {
  require_not_negative(viscous_Nms_rad_, "viscous coefficient", "N·m·s/rad");
}

double StribeckFriction::torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * curve_(speed_rad_s) + viscous_Nms_rad_ * speed_rad_s;
}

double StribeckFriction::torque_at_rest_Nm(double applied_Nm) const {
  const double most = curve_.parameters().static_Nm;
  return std::clamp(applied_Nm, -most, most);
}

}  // namespace tribolog
