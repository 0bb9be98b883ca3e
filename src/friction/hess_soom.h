#pragma once
// Friction of a lubricated contact after Hess and Soom (1990), as Olsson et al. (1998) put it.
//
//   T = (Tc + (Ts - Tc) / (1 + (wl/ws)^2)) sgn(w) + s2 w
//
// wl lags behind |w|: the lubricant film takes time to build up. The authors use a pure delay t;
// here it is a lag of first order with that time constant, dwl/dt = (|w| - wl)/t, equal to the
// delay to first order in t, so that the model remains a differential equation. Discontinuous at w
// = 0, without pre-sliding.

#include "friction/dynamic_friction.h"

namespace tribolog::friction {

/// State: the lagged speed wl [rad/s].
class HessSoomFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double coulomb_Nm{};               ///< Tc > 0
    double static_Nm{};                ///< Ts >= Tc
    double stribeck_speed_rad_s{1.0};  ///< ws > 0
    double viscous_Nms_rad{};          ///< s2 >= 0
    double lag_s{};                    ///< t > 0
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit HessSoomFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "hess_soom"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override { return 1; }
  void state_scales(std::span<double> scales) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact for the step's parabola of speed.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

}  // namespace tribolog::friction
