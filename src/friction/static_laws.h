#pragma once
// Friction laws that depend on speed alone, eq. (1), (2), (6) and (7).

#include "friction/friction_model.h"

namespace tribolog::friction {

// The part of friction that falls from break-away to Coulomb torque as speed grows.

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
  /// Friction torque [N·m] in motion. At rest any torque between -Ts and Ts is possible, and the
  /// applied torque determines it; from speed alone it is 0, the middle of these.
  [[nodiscard]] double torque_Nm(double speed_rad_s) const override;
  /// Friction torque [N·m] at rest against an applied torque: equal to it up to Ts.
  [[nodiscard]] double torque_at_rest_Nm(double applied_Nm) const;

 private:
  Parameters p_;
  StribeckCurve curve_;
};

// Static friction made continuous by a threshold speed, eq. (2).
//
//   Tf = (Tc + (Ts - Tc) exp(-cw |w|)) sgn(w) + f w,     |w| >= wth
//   Tf = w/wth * Tf(wth),                                |w| <  wth
//
// In print both branches say |w| >= wth; continuity at wth shows what is meant (errata). Below the
// threshold the shaft creeps under any torque: it never holds.

class ThresholdSpeedFriction final : public StaticFriction {
 public:
  struct Parameters {
    double coulomb_Nm{};            ///< Tc > 0
    double static_Nm{};             ///< Ts >= Tc, T_brk in print
    double stribeck_decay_s_rad{};  ///< cw >= 0
    double viscous_Nms_rad{};       ///< f >= 0
    double threshold_rad_s{1e-4};   ///< wth > 0; the paper: 1e-5 to 1e-3
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit ThresholdSpeedFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "threshold_speed"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  /// Friction torque [N·m]; continuous and odd.
  [[nodiscard]] double torque_Nm(double speed_rad_s) const override;

 private:
  [[nodiscard]] double sliding_Nm(double absolute_speed_rad_s) const;
  Parameters p_;
};

// Static friction of a geared robot joint after Waiboer, Aarts and Jonker (2005), eq. (6), made
// continuous through zero speed by eq. (7).
//
//   T(w)  = Ta exp(-(w/ws)^da) + cv w^(1-dv),      w = |motor speed| >= 0          (6)
//   Tf(w) = (2/pi) arctan(c w) T(|w|)                                              (7)
//
// Ta: torque of the asperities (static torque at rest), ws: Stribeck velocity, da: Stribeck power,
// cv: viscous coefficient, dv: viscous power. The curve is dissipative: Tf w >= 0 at every speed.

class WaiboerFriction final : public StaticFriction {
 public:
  struct Parameters {
    double asperity_torque_Nm{};       ///< Ta >= 0
    double stribeck_speed_rad_s{1.0};  ///< ws > 0
    double stribeck_power{1.0};        ///< da > 0
    double viscous_coefficient{};      ///< cv >= 0 [N·m (s/rad)^(1-dv)]
    double viscous_power{};            ///< 0 <= dv < 1
    double smoothing_s_rad{1e6};       ///< c > 0 of eq. (7)
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit WaiboerFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "waiboer"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  /// Friction torque [N·m] at signed motor speed [rad/s], eq. (7).
  [[nodiscard]] double torque_Nm(double speed_rad_s) const override;
  /// Eq. (6) alone: torque [N·m] at the absolute speed, without the smoothing.
  [[nodiscard]] double magnitude_Nm(double absolute_speed_rad_s) const;

 private:
  Parameters p_;
};

}  // namespace tribolog::friction
