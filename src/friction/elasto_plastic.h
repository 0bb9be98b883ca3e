#pragma once
// Elasto-plastic friction (Dupont, Hayward, Armstrong, Altpeter 2002): LuGre without its drift.
//
//   dz/dt = w (1 - a(z, w) sgn(w) z / g(w)),     s0 g(w) = s(w)
//   T = s0 z + s1 dz/dt + s2 w
//
// a = 0 while |z| <= zba or z is against the motion: the bristle is purely elastic and comes back
// to where it was. From zba to g(w) a rises to 1 along a sine; at 1 this is LuGre.

#include "friction/dynamic_friction.h"
#include "friction/stribeck.h"

namespace tribolog::friction {

/// State: the bristle deflection z [rad].
class ElastoPlasticFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double bristle_stiffness_Nm_rad{};   ///< s0 > 0
    double bristle_damping_Nms_rad{};    ///< s1 >= 0
    double viscous_Nms_rad{};            ///< s2 >= 0
    StribeckCurve::Parameters curve;     ///< s(w)
    double break_away_deflection_rad{};  ///< 0 < zba < Tc/s0, so that it is below every g(w)
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit ElastoPlasticFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "elasto_plastic"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override { return 1; }
  void state_scales(std::span<double> scales) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact while elastic, else by exponential steps of 4th order, halved where z bends sharply.
  void advance(std::span<double> state, const SpeedStep& step) const override;
  void respond(std::span<double> state, std::span<const SpeedStep> steps,
               std::span<double> torque_Nm) const override;

 private:
  struct Bending;
  /// g(w) [rad], and 1/(g - zba) with it.
  struct SteadyDeflection {
    double rad;
    double per_way_to_it;
  };
  [[nodiscard]] SteadyDeflection steady_deflection(double speed_rad_s) const;
  /// 1 - a(z, w), for a deflection counted in the direction of motion.
  [[nodiscard]] double elastic_share(double deflection_rad, const SteadyDeflection& g) const;
  [[nodiscard]] double rate_rad_s(double z_rad, double speed_rad_s,
                                  const SteadyDeflection& g) const;
  [[nodiscard]] double torque_Nm(double z_rad, double speed_rad_s, const SteadyDeflection& g) const;

  Parameters p_;
  StribeckCurve curve_;
  double compliance_rad_Nm_;
};

}  // namespace tribolog::friction
