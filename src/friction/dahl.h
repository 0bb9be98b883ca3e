#pragma once
// Dahl's friction (1968): the torque follows the way like the stress in a strained solid.
//
//   dT/dx = s0 |1 - sgn(w) T/Tc|^i sgn(1 - sgn(w) T/Tc)
//
// x: angle. i = 1 is the usual case, and LuGre without Stribeck effect and damping. Rate
// independent: no break-away torque above Tc, no Stribeck effect, no viscous part of its own.

#include "friction/dynamic_friction.h"

namespace tribolog::friction {

/// State: the torque T [N·m].
class DahlFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double stiffness_Nm_rad{};  ///< s0 > 0, at zero torque
    double coulomb_Nm{};        ///< Tc > 0
    double exponent{1.0};       ///< i >= 0; ductile above 1, brittle below
    double viscous_Nms_rad{};   ///< >= 0; added to the torque
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit DahlFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "dahl"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override { return 1; }
  void state_scales(std::span<double> scales) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact for every exponent and any course of the speed.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

}  // namespace tribolog::friction
