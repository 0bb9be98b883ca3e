#pragma once
// The reset integrator of Haessig and Friedland (1990).
//
//   dz/dt = 0 if z has reached its bound z0 in the direction of motion, else w
//   T = (1 + a(z)) s0 z + s1 dz/dt,     a(z) = a for |z| < z0, 0 at the bound
//
// The bristle is bonded within |z| < z0, with a peak of (1 + a) s0 z0 just before it breaks, and
// slides with s0 z0 at the bound. Discontinuous at break-away.

#include "friction/dynamic_friction.h"

namespace tribolog::friction {

/// State: the deflection z [rad], then 0 while bonded or the direction (-1, 1) of sliding.
class ResetIntegratorFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double stiffness_Nm_rad{};        ///< s0 > 0
    double damping_Nms_rad{};         ///< s1 >= 0
    double largest_deflection_rad{};  ///< z0 > 0; Coulomb torque is s0 z0
    double stiction_gain{};           ///< a >= 0; break-away torque is (1 + a) s0 z0
    double viscous_Nms_rad{};         ///< >= 0; added to the torque
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit ResetIntegratorFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "reset_integrator"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override { return 2; }
  void state_scales(std::span<double> scales) const override;
  [[nodiscard]] std::size_t events() const override { return 1; }
  void event_values(std::span<const double> state, double speed_rad_s,
                    std::span<double> values) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  void settle(std::span<double> state, double speed_rad_s) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact for any course of the speed.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

}  // namespace tribolog::friction
