// Dahl's friction (1968): the torque follows the displacement as stress follows strain in a solid.
//
//   dT/dx = s0 |1 - sgn(w) T/Tc|^i sgn(1 - sgn(w) T/Tc)
//
// x: angle. i = 1 is the usual case, and LuGre without Stribeck effect and damping. Rate
// independent: no break-away torque above Tc, no Stribeck effect, no viscous part of its own.

#include <algorithm>
#include <cmath>

#include "base/requirements.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"

namespace tribolog::friction {
namespace {

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
  /// Exact for every exponent and any speed profile.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

ParameterSlots DahlFriction::Parameters::by_name() {
  return {{"stiffness_Nm_rad", &stiffness_Nm_rad},
          {"coulomb_Nm", &coulomb_Nm},
          {"exponent", &exponent, true},
          {"viscous_Nms_rad", &viscous_Nms_rad}};
}

DahlFriction::DahlFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_not_negative(p_.exponent, "Dahl's exponent", "");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

void DahlFriction::rates(std::span<const double> state, double speed_rad_s,
                         std::span<double> rates) const {
  const double left = 1 - direction_of(speed_rad_s) * state[0] / p_.coulomb_Nm;
  const double slope = std::pow(std::abs(left), p_.exponent) * direction_of(left);
  rates[0] = p_.stiffness_Nm_rad * slope * speed_rad_s;
}

double DahlFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  return state[0] + p_.viscous_Nms_rad * speed_rad_s;
}

double DahlFriction::steady_torque_Nm(double speed_rad_s) const {
  return direction_of(speed_rad_s) * p_.coulomb_Nm + p_.viscous_Nms_rad * speed_rad_s;
}

// With u = 1 - sgn(w) T/Tc and y = s0 |way| / Tc the model reads du/dy = -u^i.
void DahlFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const double u0 = 1 - direction * state[0] / p_.coulomb_Nm;
  const double y = p_.stiffness_Nm_rad * std::abs(step.path_rad()) / p_.coulomb_Nm;
  const double size = std::abs(u0);
  double end = 0;
  if (p_.exponent == 1.0) {
    end = size * std::exp(-y);
  } else if (size > 0) {
    const double k = 1 - p_.exponent;
    const double power = std::pow(size, k) - k * y;
    end = power > 0 ? std::pow(power, 1 / k) : 0.0;
  }
  state[0] = direction * p_.coulomb_Nm * (1 - std::copysign(end, u0));
}

void DahlFriction::state_scales(std::span<double> scales) const { scales[0] = p_.coulomb_Nm; }

DahlFriction::Parameters dahl(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.coulomb_Nm, 1.0, c.viscous_Nms_rad};
}

}  // namespace

FrictionModelEntry dahl_model() {
  return model<DahlFriction>({.presliding = true, .drifts = true, .rate_independent = true}, dahl);
}

}  // namespace tribolog::friction
