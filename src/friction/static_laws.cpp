#include "friction/static_laws.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/friction_model.h"

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
