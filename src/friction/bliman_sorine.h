#pragma once
// Friction of Bliman and Sorine (1991, 1995): a linear system along the way travelled.
//
//   dx1/ds = -x1/(eta e) + f1/(eta e) sgn(w)
//   dx2/ds = -x2/e       - f2/e       sgn(w)
//   T = x1 + x2,    s = integral of |w| dt
//
// Rate independent. The faster part x1 rises to f1 over the way eta e, the slower one pulls back by
// f2 over e: on the way to the Coulomb torque f1 - f2 the torque goes through a peak, which is how
// the second order model shows break-away.

#include "friction/dynamic_friction.h"

namespace tribolog::friction {

/// State: x1, x2 [N·m].
class BlimanSorineFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double fast_torque_Nm{};   ///< f1 > 0
    double slow_torque_Nm{};   ///< 0 <= f2 < f1; Coulomb torque is f1 - f2
    double slow_way_rad{};     ///< e > 0
    double way_ratio{0.5};     ///< 0 < eta < 1
    double viscous_Nms_rad{};  ///< >= 0; added to the torque
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit BlimanSorineFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "bliman_sorine"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  /// Largest torque [N·m] on the way from an unloaded contact to steady sliding.
  [[nodiscard]] double break_away_Nm() const;

  [[nodiscard]] std::size_t states() const override { return 2; }
  void state_scales(std::span<double> scales) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact for any course of the speed.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

}  // namespace tribolog::friction
