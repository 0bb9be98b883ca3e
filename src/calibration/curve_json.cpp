// Stage 8.

#include <cmath>
#include <optional>

#include "calibration/parts.h"

namespace tribolog::calibration {

void state_friction(Fields& f, const Calibration& c, double n) {
  f.text_or_null("curve", std::string(to_string(c.friction.curve)), "Whose curve was fitted.");
  f.object_or_null(
      "waiboer", c.friction.waiboer,
      "Eq. (6): Ta exp(-(w/ws)^da) + cv w^(1-dv). Null where the curve has too few speeds.",
      [n](Fields& of, const method::viscous::WaiboerFit& w) {
        of.flag("converged", w.converged);
        of.both_sides("asperity_torque_Nm", w.asperity_torque_Nm, n);
        of.both_sides("stribeck_speed_rad_s", w.stribeck_speed_rad_s, 1.0 / n);
        of.interval("stribeck_power", w.stribeck_power);
        of.both_sides("viscous_coefficient", w.viscous_coefficient,
                      std::pow(n, 2.0 - w.viscous_power.value),
                      "Joint side: times n^(2-dv) at the estimated dv.");
        of.interval("viscous_power", w.viscous_power);
        of.number("residual_Nm", w.residual_Nm);
      });
  f.object_or_null(
      "lugre", c.lugre,
      "LuGre model fitted to the hysteresis loops. A parameter that they do not show is null on "
      "both sides. Null where no loop was fitted.",
      [n](Fields& of, const method::hysteresis::LuGreFit& fit) { state_lugre(of, fit, n); });
}

}  // namespace tribolog::calibration
