// The reset integrator of Haessig and Friedland (1990).
//
//   dz/dt = 0 if z has reached its bound z0 in the direction of motion, else w
//   T = (1 + a(z)) s0 z + s1 dz/dt,     a(z) = a for |z| < z0, 0 at the bound
//
// The bristle is bonded within |z| < z0, with a peak of (1 + a) s0 z0 just before it breaks, and
// slides with s0 z0 at the bound. Discontinuous at break-away.

#include <cmath>

#include "base/requirements.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"

namespace tribolog::friction {
namespace {

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
  /// Exact for any speed profile.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

enum ResetMember : std::size_t { bristle_deflection, slip_direction };

ParameterSlots ResetIntegratorFriction::Parameters::by_name() {
  return {{"stiffness_Nm_rad", &stiffness_Nm_rad},
          {"damping_Nms_rad", &damping_Nms_rad},
          {"largest_deflection_rad", &largest_deflection_rad},
          {"stiction_gain", &stiction_gain},
          {"viscous_Nms_rad", &viscous_Nms_rad}};
}

ResetIntegratorFriction::ResetIntegratorFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.stiffness_Nm_rad, "stiffness", "N·m/rad");
  require_not_negative(p_.damping_Nms_rad, "damping", "N·m·s/rad");
  require_positive(p_.largest_deflection_rad, "largest deflection", "rad");
  require_not_negative(p_.stiction_gain, "stiction gain", "");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

void ResetIntegratorFriction::rates(std::span<const double> state, double speed_rad_s,
                                    std::span<double> rates) const {
  rates[bristle_deflection] = state[slip_direction] == 0.0 ? speed_rad_s : 0.0;
  rates[slip_direction] = 0;
}

void ResetIntegratorFriction::settle(std::span<double> state, double speed_rad_s) const {
  const double direction = direction_of(speed_rad_s);
  if (state[slip_direction] != direction) state[slip_direction] = 0;
  const double bound = p_.largest_deflection_rad;
  if (direction * state[bristle_deflection] < bound || direction == 0.0) return;
  state[bristle_deflection] = direction * bound;
  state[slip_direction] = direction;
}

double ResetIntegratorFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const bool is_bonded = std::abs(state[bristle_deflection]) < p_.largest_deflection_rad;
  const double gain = is_bonded ? 1 + p_.stiction_gain : 1.0;
  const double rate = state[slip_direction] == 0.0 ? speed_rad_s : 0.0;
  return gain * p_.stiffness_Nm_rad * state[bristle_deflection] + p_.damping_Nms_rad * rate +
         p_.viscous_Nms_rad * speed_rad_s;
}

double ResetIntegratorFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * p_.stiffness_Nm_rad * p_.largest_deflection_rad + p_.viscous_Nms_rad * speed_rad_s;
}

void ResetIntegratorFriction::advance(std::span<double> state, const SpeedStep& step) const {
  state[bristle_deflection] += step.path_rad();
  settle(state, step.direction());
}

void ResetIntegratorFriction::state_scales(std::span<double> scales) const {
  scales[bristle_deflection] = p_.largest_deflection_rad;
  scales[slip_direction] = 1;
}

void ResetIntegratorFriction::event_values(std::span<const double> state, double /*speed_rad_s*/,
                                           std::span<double> values) const {
  const bool is_bonded = state[slip_direction] == 0.0;
  values[0] = is_bonded ? std::abs(state[bristle_deflection]) - p_.largest_deflection_rad : 1.0;
}

ResetIntegratorFriction::Parameters reset_integrator(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.damping_Nms_rad, c.coulomb_Nm / c.stiffness_Nm_rad,
          c.static_Nm / c.coulomb_Nm - 1, c.viscous_Nms_rad};
}

}  // namespace

FrictionModelEntry reset_integrator_model() {
  return model<ResetIntegratorFriction>({.break_away = true, .presliding = true}, reset_integrator);
}

}  // namespace tribolog::friction
