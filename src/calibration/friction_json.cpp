// Stage 8.

#include <cmath>

#include "calibration/parts.h"

namespace tribolog::json {
namespace {

Json waiboer(const WaiboerFit& w, double n) {
  const double coefficient_to_joint = std::pow(n, 2.0 - w.viscous_power.value);
  return {{"converged", w.converged},
          {"asperity_torque_Nm", both_sides(w.asperity_torque_Nm, n)},
          {"stribeck_speed_rad_s", both_sides(w.stribeck_speed_rad_s, 1.0 / n)},
          {"stribeck_power", interval(w.stribeck_power)},
          {"viscous_coefficient", both_sides(w.viscous_coefficient, coefficient_to_joint)},
          {"viscous_power", interval(w.viscous_power)},
          {"residual_Nm", number(w.residual_Nm)}};
}

Json coulomb_viscous(const CoulombViscousFit& f, double n) {
  return {{"coulomb_Nm", both_sides(f.coulomb_Nm, n)},
          {"viscous_Nms_rad", both_sides(f.viscous_Nms_rad, n * n)},
          {"residual_Nm", number(f.residual_Nm)},
          {"slowest_rad_s", number(f.slowest_rad_s)},
          {"fastest_rad_s", number(f.fastest_rad_s)}};
}

}  // namespace

Json friction(const Calibration& c, double n) {
  const FrictionParametersResult& f = c.friction;
  Json made{{"curve", text_or_null(f.curve)},
            {"waiboer", nullptr},
            {"coulomb_viscous", nullptr},
            {"lugre", nullptr}};
  if (f.waiboer) made["waiboer"] = waiboer(*f.waiboer, n);
  if (f.coulomb_viscous) made["coulomb_viscous"] = coulomb_viscous(*f.coulomb_viscous, n);
  if (c.hysteresis.lugre) made["lugre"] = lugre(*c.hysteresis.lugre, n);
  return made;
}

}  // namespace tribolog::json
