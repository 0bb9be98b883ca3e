#include "friction/stribeck.h"

#include <algorithm>
#include <cmath>

#include "base/requirements.h"
#include "friction/speed_step.h"

namespace tribolog::friction {

ParameterSlots StribeckCurve::Parameters::by_name() {
  return {{"coulomb_Nm", &coulomb_Nm},
          {"static_Nm", &static_Nm},
          {"stribeck_speed_rad_s", &stribeck_speed_rad_s},
          {"stribeck_power", &power, true}};
}

StribeckCurve::StribeckCurve(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_positive(p_.static_Nm, "static torque", "N·m");
  require_positive(p_.stribeck_speed_rad_s, "Stribeck velocity", "rad/s");
  require_positive(p_.power, "Stribeck power", "");
  require_not_above(p_.coulomb_Nm, "Coulomb torque", p_.static_Nm, "static torque", "N·m");
}

double StribeckCurve::operator()(double speed_rad_s) const {
  const double x = std::abs(speed_rad_s) / p_.stribeck_speed_rad_s;
  const double exponent = p_.power == 2.0 ? x * x : std::pow(x, p_.power);
  return p_.coulomb_Nm + (p_.static_Nm - p_.coulomb_Nm) * std::exp(-exponent);
}

ParameterSlots StribeckFriction::Parameters::by_name() {
  return joined({curve.by_name(), ParameterSlots{{"viscous_Nms_rad", &viscous_Nms_rad}}});
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

}  // namespace tribolog::friction
