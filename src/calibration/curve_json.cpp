// Stage 8.

#include <cmath>
#include <utility>

#include "calibration/parts.h"
#include "wording/words.h"

namespace tribolog::calibration {

namespace {

Json waiboer(const method::viscous::WaiboerFit& w, double n) {
  const double coefficient_to_joint = std::pow(n, 2.0 - w.viscous_power.value);
  return {{"converged", w.converged},
          {"asperity_torque_Nm", both_sides(w.asperity_torque_Nm, n)},
          {"stribeck_speed_rad_s", both_sides(w.stribeck_speed_rad_s, 1.0 / n)},
          {"stribeck_power", interval(w.stribeck_power)},
          {"viscous_coefficient", both_sides(w.viscous_coefficient, coefficient_to_joint)},
          {"viscous_power", interval(w.viscous_power)},
          {"residual_Nm", number(w.residual_Nm)}};
}

}  // namespace

Json friction(const Calibration& c, double n) {
  const method::selection::FrictionParametersResult& f = c.friction;
  Json made{{"curve", text_or_null(to_string(f.curve))}, {"waiboer", nullptr}, {"lugre", nullptr}};
  if (f.waiboer) made["waiboer"] = waiboer(*f.waiboer, n);
  if (c.lugre) made["lugre"] = lugre(*c.lugre, n);
  return made;
}

}  // namespace tribolog::calibration
