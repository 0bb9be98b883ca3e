#pragma once
// Generalised Maxwell-slip friction (Al-Bender, Lampaert, Swevers 2005).
//
//   element i sticks:  dTi/dt = ki w                                until |Ti| = ai s(w)
//   element i slips:   dTi/dt = sgn(w) C (ai - sgn(w) Ti / s(w))    until w goes through zero
//   T = sum Ti + s2 w
//
// Rate-independent hysteresis with non-local memory in pre-sliding, Stribeck curve and frictional
// lag (by C) in sliding.

#include "friction/dynamic_friction.h"
#include "friction/maxwell_slip.h"
#include "friction/stribeck.h"

namespace tribolog::friction {

/// State: T1 ... Tn [N·m], then for each element 0 while it sticks or the direction (-1, 1) in
/// which it slips.
class GmsFriction final : public DynamicFriction {
 public:
  struct Parameters {
    std::vector<MaxwellElement> elements;  ///< ki and ai
    StribeckCurve::Parameters curve;       ///< s(w)
    double attraction_Nm_s{};              ///< C > 0: how fast slipping torque follows s(w)
    double viscous_Nms_rad{};              ///< s2 >= 0
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit GmsFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "gms"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override { return 2 * p_.elements.size(); }
  void state_scales(std::span<double> scales) const override;
  [[nodiscard]] std::size_t events() const override { return p_.elements.size(); }
  void event_values(std::span<const double> state, double speed_rad_s,
                    std::span<double> values) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  void settle(std::span<double> state, double speed_rad_s) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Sticking exact, the moment of slip found by false position, slipping by the exponential step.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  struct CurvedStep;
  /// When, as a share of the step's duration, a sticking element that slips at its end begins to.
  [[nodiscard]] double slip_moment(double torque_Nm, const MaxwellElement& element,
                                   const CurvedStep& curved) const;
  void slip(double& torque_Nm, double share, const CurvedStep& curved) const;

  Parameters p_;
  StribeckCurve curve_;
};

}  // namespace tribolog::friction
