#pragma once
// The Leuven integrated model (Swevers, Al-Bender, Ganseman, Prajogo 2000), with its hysteresis
// torque from Maxwell-slip elements, as Lampaert, Swevers and Al-Bender (2002) put it to remove the
// jump that the original has where an inner loop closes.
//
//   dz/dt = w (1 - sgn(w) sgn(Th) |Th(z) / s(w)|^n)
//   T = Th(z) + s1 dz/dt + s2 w
//
// Th(z): torque of the elements at the deflection z, with non-local memory: an inner loop closes
// where it was left. In sliding Th -> s(w).

#include "friction/dynamic_friction.h"
#include "friction/maxwell_slip.h"
#include "friction/stribeck.h"

namespace tribolog::friction {

/// State: z [rad], then the torque of each element [N·m].
class LeuvenFriction final : public DynamicFriction {
 public:
  struct Parameters {
    std::vector<MaxwellElement> elements;
    StribeckCurve::Parameters curve;  ///< s(w)
    double transition_power{2.0};     ///< n >= 1
    double micro_damping_Nms_rad{};   ///< s1 >= 0
    double viscous_Nms_rad{};         ///< s2 >= 0
    ParameterSlots by_name();
  };

  /// The elements could carry `reserve` times the static torque, so that the hysteresis torque is
  /// still rising when sliding begins.
  static constexpr double reserve = 1.25;

  /// @throw Refusal stating the value and the rule.
  explicit LeuvenFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "leuven"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override { return 1 + p_.elements.size(); }
  void state_scales(std::span<double> scales) const override;
  [[nodiscard]] std::size_t events() const override { return p_.elements.size(); }
  void event_values(std::span<const double> state, double speed_rad_s,
                    std::span<double> values) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  void settle(std::span<double> state, double speed_rad_s) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// By exponential steps of 4th order, cut where an element reaches its limit or z turns
  /// round (towards a falling s).
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  struct Relaxing;
  struct Stretching;
  [[nodiscard]] double limit_Nm(std::size_t element) const;
  /// Th, torque of the elements.
  [[nodiscard]] double hysteresis_Nm(std::span<const double> state) const;
  /// |Th/s|^n
  [[nodiscard]] double to_transition_power(double ratio) const;
  /// dz/dx in the direction of motion.
  [[nodiscard]] double slope(double hysteresis_Nm, double speed_rad_s) const;
  [[nodiscard]] Stretching stretching(std::span<const double> state, double direction) const;
  /// z and the elements after a further deflection.
  void stretch(std::span<double> state, double further_rad) const;
  /// Advances until the next element reaches its limit or z turns round; returns when, as a share
  /// of the step.
  /// @param way 1 while z moves with the motion, -1 against it; changed where it turns.
  double advance_until_change(std::span<double> state, const SpeedStep& step, double& way) const;

  Parameters p_;
  StribeckCurve curve_;
  double stiffness_Nm_rad_{};
};

}  // namespace tribolog::friction
