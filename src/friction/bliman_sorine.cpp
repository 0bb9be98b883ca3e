#include "friction/bliman_sorine.h"

#include <cmath>

#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::friction {

ParameterSlots BlimanSorineFriction::Parameters::by_name() {
  return {{"fast_torque_Nm", &fast_torque_Nm},
          {"slow_torque_Nm", &slow_torque_Nm},
          {"slow_way_rad", &slow_way_rad},
          {"way_ratio", &way_ratio, true},
          {"viscous_Nms_rad", &viscous_Nms_rad}};
}

BlimanSorineFriction::BlimanSorineFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.fast_torque_Nm, "torque f1", "N·m");
  require_not_negative(p_.slow_torque_Nm, "torque f2", "N·m");
  require_positive(p_.slow_way_rad, Code{"parameter.slow_way"}, "rad");
  require_positive(p_.way_ratio, Code{"parameter.way_ratio"}, "");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  if (p_.slow_torque_Nm >= p_.fast_torque_Nm) {
    throw Refusal({"bliman_sorine.slow_torque_not_below_fast",
                   {{"slow_Nm", p_.slow_torque_Nm}, {"fast_Nm", p_.fast_torque_Nm}}});
  }
  if (p_.way_ratio >= 1) {
    throw Refusal({"bliman_sorine.way_ratio_not_below_one", {{"ratio", p_.way_ratio}}});
  }
}

// T(s) = f1 (1 - exp(-s/(eta e))) - f2 (1 - exp(-s/e)) is steepest down where its slope is zero.
double BlimanSorineFriction::break_away_Nm() const {
  const double f1 = p_.fast_torque_Nm;
  const double f2 = p_.slow_torque_Nm;
  const double eta = p_.way_ratio;
  if (f2 == 0.0) return f1;
  const double s = std::log(f1 / (eta * f2)) * eta / (1 - eta);  // in units of e
  return f1 * -std::expm1(-s / eta) - f2 * -std::expm1(-s);
}

void BlimanSorineFriction::rates(std::span<const double> state, double speed_rad_s,
                                 std::span<double> rates) const {
  const double slow = 1 / p_.slow_way_rad;
  const double fast = slow / p_.way_ratio;
  rates[0] = fast * (p_.fast_torque_Nm * speed_rad_s - state[0] * std::abs(speed_rad_s));
  rates[1] = slow * (-p_.slow_torque_Nm * speed_rad_s - state[1] * std::abs(speed_rad_s));
}

double BlimanSorineFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  return state[0] + state[1] + p_.viscous_Nms_rad * speed_rad_s;
}

double BlimanSorineFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * (p_.fast_torque_Nm - p_.slow_torque_Nm) + p_.viscous_Nms_rad * speed_rad_s;
}

void BlimanSorineFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  const double way = std::abs(step.path_rad()) / p_.slow_way_rad;
  const double end1 = direction * p_.fast_torque_Nm;
  const double end2 = -direction * p_.slow_torque_Nm;
  state[0] = end1 + (state[0] - end1) * std::exp(-way / p_.way_ratio);
  state[1] = end2 + (state[1] - end2) * std::exp(-way);
}

void BlimanSorineFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.fast_torque_Nm;
  scales[1] = p_.fast_torque_Nm;
}

}  // namespace tribolog::friction
