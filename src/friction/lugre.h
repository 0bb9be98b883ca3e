#pragma once
// LuGre friction (Canudas de Wit, Olsson, Astrom, Lischinsky 1995), eq. (3) to (5).
//
//   Tf    = s0 z + s1(w) dz/dt + s2 w                           (3)
//   dz/dt = w - |w| z / g(w)                                    (4)
//   s0 g(w) = Tc + (Ts - Tc) exp(-(|w|/ws)^d)                   (5), where d = 2
//   s1(w)   = s1 exp(-(w/wd)^2)            Olsson et al. 1998; constant unless wd is given
//
// z: mean bristle deflection [rad, motor side], w: motor speed [rad/s].

#include "friction/friction_model.h"

namespace tribolog::friction {

/// State: the mean bristle deflection z [rad].
class LuGreFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double bristle_stiffness_Nm_rad{};  ///< s0 > 0
    double bristle_damping_Nms_rad{};   ///< s1 >= 0
    double viscous_Nms_rad{};           ///< s2 >= 0
    double coulomb_Nm{};                ///< Tc > 0
    double static_Nm{};                 ///< Ts >= Tc, break-away torque
    double stribeck_speed_rad_s{1.0};   ///< ws > 0
    double stribeck_power{2.0};         ///< d > 0
    double damping_speed_rad_s{0.0};    ///< wd >= 0; 0: s1 is constant
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule, e.g. that the Coulomb torque exceeds the static
  /// one.
  explicit LuGreFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "lugre"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  /// g(w) [rad]: the bristle deflection in steady sliding at this speed, always > 0.
  [[nodiscard]] double steady_deflection_rad(double speed_rad_s) const;
  /// dz/dt [rad/s], eq. (4).
  [[nodiscard]] double deflection_rate_rad_s(double z_rad, double speed_rad_s) const;
  /// s1(w) [N·m·s/rad].
  [[nodiscard]] double damping_Nms_rad(double speed_rad_s) const;
  /// Friction torque [N·m], eq. (3).
  [[nodiscard]] double torque_Nm(double z_rad, double dz_rad_s, double speed_rad_s) const;
  /// Torque of steady sliding at constant speed [N·m]: sgn(w) s0 g(w) + s2 w.
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;

  [[nodiscard]] std::size_t states() const override { return 1; }
  void state_scales(std::span<double> scales) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  /// The exponential step, 4th order. Long records: simulate/bristle_integrator.h.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

}  // namespace tribolog::friction
