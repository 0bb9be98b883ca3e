#pragma once
// Static friction with Coulomb torque, Stribeck effect and viscous part, eq. (1); discontinuous.
//
//   Tf = (Tc + (Ts - Tc) exp(-(w/ws)^2) + Tw |w|) sgn(w),   w != 0
//   |Tf| <= Ts,                                             w  = 0
//
// In print sgn(w) stands on a line of its own; it multiplies the whole first line (errata).

#include "friction/stribeck_curve.h"

namespace tribolog {

class StribeckFriction {
 public:
  struct Parameters {
    StribeckCurve::Parameters curve;  ///< Ts is T_brk of eq. (1).
    double viscous_Nms_rad{};         ///< Tw >= 0
  };

  /// @throw std::invalid_argument quoting the value and the rule.
  explicit StribeckFriction(const Parameters& parameters);

  [[nodiscard]] const StribeckCurve& curve() const { return curve_; }
  [[nodiscard]] double viscous_Nms_rad() const { return viscous_Nms_rad_; }
  /// Friction torque [N·m] in motion; 0 at rest, where the torque is not a function of speed.
  [[nodiscard]] double torque_Nm(double speed_rad_s) const;
  /// Friction torque [N·m] at rest against an applied torque: equal to it up to Ts.
  [[nodiscard]] double torque_at_rest_Nm(double applied_Nm) const;

 private:
  StribeckCurve curve_;
  double viscous_Nms_rad_;
};

}  // namespace tribolog
