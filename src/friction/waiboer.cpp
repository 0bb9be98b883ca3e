#include "friction/waiboer.h"

#include <cmath>
#include <numbers>

#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::friction {

ParameterSlots WaiboerFriction::Parameters::by_name() {
  return {
      {"asperity_torque_Nm", &asperity_torque_Nm}, {"stribeck_speed_rad_s", &stribeck_speed_rad_s},
      {"stribeck_power", &stribeck_power},         {"viscous_coefficient", &viscous_coefficient},
      {"viscous_power", &viscous_power},           {"smoothing_s_rad", &smoothing_s_rad, true}};
}

WaiboerFriction::WaiboerFriction(const Parameters& parameters) : p_(parameters) {
  require_not_negative(p_.asperity_torque_Nm, "asperity torque", "N·m");
  require_positive(p_.stribeck_speed_rad_s, "Stribeck velocity", "rad/s");
  require_positive(p_.stribeck_power, "Stribeck power", "");
  require_not_negative(p_.viscous_coefficient, "viscous coefficient", "");
  require_not_negative(p_.viscous_power, "viscous power", "");
  require_positive(p_.smoothing_s_rad, Code{"parameter.smoothing"}, "s/rad");
  if (p_.viscous_power >= 1) {
    throw Refusal({"waiboer.viscous_power_not_below_one", {{"power", p_.viscous_power}}});
  }
}

double WaiboerFriction::magnitude_Nm(double absolute_speed_rad_s) const {
  const double w = absolute_speed_rad_s;
  const double asperity =
      p_.asperity_torque_Nm * std::exp(-std::pow(w / p_.stribeck_speed_rad_s, p_.stribeck_power));
  const double viscous = p_.viscous_coefficient * std::pow(w, 1 - p_.viscous_power);
  return asperity + viscous;
}

double WaiboerFriction::torque_Nm(double speed_rad_s) const {
  return 2 / std::numbers::pi * std::atan(p_.smoothing_s_rad * speed_rad_s) *
         magnitude_Nm(std::abs(speed_rad_s));
}

}  // namespace tribolog::friction
