#include "friction/stribeck_curve.h"

#include <cmath>

#include "base/parameter_rules.h"

namespace tribolog {

ParameterSlots StribeckCurve::Parameters::by_name() {
  return {{"coulomb_Nm", "Tc > 0", &coulomb_Nm},
          {"static_Nm", "Ts >= Tc, break-away torque", &static_Nm},
          {"stribeck_speed_rad_s", "ws > 0", &stribeck_speed_rad_s},
          {"stribeck_power", "d > 0", &power, true}};
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

}  // namespace tribolog
