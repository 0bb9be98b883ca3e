#pragma once
// Static friction made continuous by a threshold speed, eq. (2).
//
//   Tf = (Tc + (Ts - Tc) exp(-cw |w|)) sgn(w) + f w,     |w| >= wth
//   Tf = w/wth * Tf(wth),                                |w| <  wth
//
// In print both branches say |w| >= wth; continuity at wth shows what is meant (errata). Below the
// threshold the shaft creeps under any torque: it never holds.

#include "friction/static_friction.h"

namespace tribolog::friction {

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

}  // namespace tribolog::friction
