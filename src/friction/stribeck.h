#pragma once
// Static friction with Coulomb torque, Stribeck effect and viscous part, eq. (1); discontinuous.
//
//   Tf = (Tc + (Ts - Tc) exp(-(w/ws)^2) + Tw |w|) sgn(w),   w != 0
//   |Tf| <= Ts,                                             w  = 0
//
// In print sgn(w) stands on a line of its own; it multiplies the whole first line (errata).

#include "friction/static_friction.h"
#include "friction/stribeck_curve.h"

namespace tribolog {

class StribeckFriction final : public StaticFriction {
 public:
  struct Parameters {
    StribeckCurve::Parameters curve;  ///< Ts is T_brk of eq. (1).
    double viscous_Nms_rad{};         ///< Tw >= 0
    ParameterSlots by_name();
  };

  /// @throw std::invalid_argument quoting the value and the rule.
  explicit StribeckFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "stribeck"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] const StribeckCurve& curve() const { return curve_; }
  /// Friction torque [N·m] in motion. At rest any torque up to Ts is possible, and it is the
  /// applied torque that says which; by speed alone the answer is 0, the middle of them.
  [[nodiscard]] double torque_Nm(double speed_rad_s) const override;
  /// Friction torque [N·m] at rest against an applied torque: equal to it up to Ts.
  [[nodiscard]] double torque_at_rest_Nm(double applied_Nm) const;

 private:
  Parameters p_;
  StribeckCurve curve_;
};

}  // namespace tribolog
