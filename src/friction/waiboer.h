#pragma once
// Static friction of a geared robot joint after Waiboer, Aarts and Jonker (2005), eq. (6), made
// continuous through zero speed by eq. (7).
//
//   T(w)  = Ta exp(-(w/ws)^da) + cv w^(1-dv),      w = |motor speed| >= 0          (6)
//   Tf(w) = (2/pi) arctan(c w) T(|w|)                                              (7)
//
// Ta: torque of the asperities (static torque at rest), ws: Stribeck velocity, da: Stribeck power,
// cv: viscous coefficient, dv: viscous power. The curve is dissipative: Tf w >= 0 at every speed.

#include "friction/static_friction.h"

namespace tribolog::friction {

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
