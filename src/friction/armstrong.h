#pragma once
// Armstrong's seven-parameter model of lubricated contacts (Armstrong-Hélouvry, Dupont, Canudas de
// Wit 1994).
//
//   sticking: T = kt x,                                        x: deflection of the junctions
//   sliding:  T = (Tc + Tv |w| + Ts(t2) / (1 + (wl/ws)^2)) sgn(w)
//   Ts(t2) = Ts,a + (Ts,inf - Ts,a) t2 / (t2 + gamma)
//
// t2: time spent sticking before; Ts,a: Stribeck torque at the end of the previous sliding.
// Sticking ends where |kt x| reaches Tc + Ts(t2): the longer the rest, the higher break-away. wl
// lags behind |w| with the frictional lag tL; as in HessSoomFriction a lag of first order stands
// for the pure delay. The seven: kt, Tc, Tv, Ts,inf, ws, tL, gamma.

#include "friction/dynamic_friction.h"

namespace tribolog::friction {

/// State: x [rad], wl [rad/s], time in this stick t2 [s], Stribeck torque Ts [N·m] of the present
/// sliding (of the last one while sticking), and 0 in sticking or the direction (-1, 1) of sliding.
class ArmstrongFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double stiffness_Nm_rad{};         ///< kt > 0
    double coulomb_Nm{};               ///< Tc > 0
    double viscous_Nms_rad{};          ///< Tv >= 0
    double rested_stribeck_Nm{};       ///< Ts,inf >= 0, after a long rest
    double stribeck_speed_rad_s{1.0};  ///< ws > 0
    double lag_s{};                    ///< tL > 0
    double rise_time_s{};              ///< gamma > 0
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit ArmstrongFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "armstrong"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  /// Torque [N·m] at which a contact breaks away that has rested so long since sliding, at whose
  /// end the Stribeck torque was `last_stribeck_Nm`.
  [[nodiscard]] double break_away_Nm(double rest_s, double last_stribeck_Nm = 0.0) const;

  [[nodiscard]] std::size_t states() const override { return 5; }
  void state_scales(std::span<double> scales) const override;
  [[nodiscard]] std::size_t events() const override { return 1; }
  void event_values(std::span<const double> state, double speed_rad_s,
                    std::span<double> values) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  void settle(std::span<double> state, double speed_rad_s) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  /// After a long rest; after a shorter one the Stribeck torque is smaller.
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact but for the moment of break-away, which false position finds.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  [[nodiscard]] double sliding_Nm(std::span<const double> state, double speed_rad_s) const;
  void lag(std::span<double> state, const SpeedStep& step) const;
  void begin_sliding(std::span<double> state, double direction) const;
  void begin_sticking(std::span<double> state) const;

  Parameters p_;
};

}  // namespace tribolog::friction
