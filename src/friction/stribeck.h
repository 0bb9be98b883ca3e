#pragma once
// The part of friction that falls from break-away to Coulomb torque as speed grows.

#include "friction/named_parameters.h"
#include "friction/static_friction.h"

namespace tribolog::friction {

/// s(w) = Tc + (Ts - Tc) exp(-(|w|/ws)^d): what eq. (1) and (5) and every model after LuGre share.
class StribeckCurve {
 public:
  struct Parameters {
    double coulomb_Nm{};               ///< Tc > 0
    double static_Nm{};                ///< Ts >= Tc, break-away torque
    double stribeck_speed_rad_s{1.0};  ///< ws > 0
    double power{2.0};                 ///< d > 0
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit StribeckCurve(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  /// s(|w|) [N·m], between Tc and Ts.
  [[nodiscard]] double operator()(double speed_rad_s) const;

 private:
  Parameters p_;
};

// Static friction with Coulomb torque, Stribeck effect and viscous part, eq. (1); discontinuous.
//
//   Tf = (Tc + (Ts - Tc) exp(-(w/ws)^2) + Tw |w|) sgn(w),   w != 0
//   |Tf| <= Ts,                                             w  = 0
//
// In print sgn(w) stands on a line of its own; it multiplies the whole first line (errata).

class StribeckFriction final : public StaticFriction {
 public:
  struct Parameters {
    StribeckCurve::Parameters curve;  ///< Ts is T_brk of eq. (1).
    double viscous_Nms_rad{};         ///< Tw >= 0
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
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

}  // namespace tribolog::friction
