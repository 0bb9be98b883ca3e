// Friction of a lubricated contact after Hess and Soom (1990), as Olsson et al. (1998) put it.
//
//   T = (Tc + (Ts - Tc) / (1 + (wl/ws)^2)) sgn(w) + s2 w
//
// wl lags behind |w|: the lubricant film takes time to build up. The authors use a pure delay t;
// here it is a first-order lag with that time constant, dwl/dt = (|w| - wl)/t, equal to the delay
// to first order in t, so that the model remains a differential equation. Discontinuous at w = 0,
// without pre-sliding.

#include <cmath>

#include "base/requirements.h"
#include "friction/exponential_step.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"

namespace tribolog::friction {
namespace {

/// State: the lagged speed wl [rad/s].
class HessSoomFriction final : public DynamicFriction {
 public:
  struct Parameters {
    double coulomb_Nm{};               ///< Tc > 0
    double static_Nm{};                ///< Ts >= Tc
    double stribeck_speed_rad_s{1.0};  ///< ws > 0
    double viscous_Nms_rad{};          ///< s2 >= 0
    double lag_s{};                    ///< t > 0
    ParameterSlots by_name();
  };

  /// @throw Refusal stating the value and the rule.
  explicit HessSoomFriction(const Parameters& parameters);

  [[nodiscard]] const Parameters& parameters() const { return p_; }
  [[nodiscard]] std::string name() const override { return "hess_soom"; }
  [[nodiscard]] NamedParameters named_parameters() const override { return named(p_); }
  [[nodiscard]] std::size_t states() const override { return 1; }
  void state_scales(std::span<double> scales) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact for the step's parabola of speed.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

ParameterSlots HessSoomFriction::Parameters::by_name() {
  return {{"coulomb_Nm", &coulomb_Nm},
          {"static_Nm", &static_Nm},
          {"stribeck_speed_rad_s", &stribeck_speed_rad_s},
          {"viscous_Nms_rad", &viscous_Nms_rad},
          {"lag_s", &lag_s}};
}

HessSoomFriction::HessSoomFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.coulomb_Nm, "Coulomb torque", "N·m");
  require_positive(p_.static_Nm, "static torque", "N·m");
  require_positive(p_.stribeck_speed_rad_s, "Stribeck velocity", "rad/s");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  require_positive(p_.lag_s, "frictional lag", "s");
  require_not_above(p_.coulomb_Nm, "Coulomb torque", p_.static_Nm, "static torque", "N·m");
}

void HessSoomFriction::rates(std::span<const double> state, double speed_rad_s,
                             std::span<double> rates) const {
  rates[0] = (std::abs(speed_rad_s) - state[0]) / p_.lag_s;
}

double HessSoomFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  const double x = state[0] / p_.stribeck_speed_rad_s;
  return sign * (p_.coulomb_Nm + (p_.static_Nm - p_.coulomb_Nm) / (1 + x * x)) +
         p_.viscous_Nms_rad * speed_rad_s;
}

double HessSoomFriction::steady_torque_Nm(double speed_rad_s) const {
  const double settled = std::abs(speed_rad_s);
  return torque_Nm({&settled, 1}, speed_rad_s);
}

void HessSoomFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double rate = 1 / p_.lag_s;
  state[0] = relaxed(relaxation_shape<double>(rate, rate, rate, std::abs(step.start_rad_s),
                                              std::abs(step.middle_rad_s), std::abs(step.end_rad_s),
                                              step.duration_s),
                     state[0]);
}

void HessSoomFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.stribeck_speed_rad_s;
}

HessSoomFriction::Parameters hess_soom(const ContactParameters& c) {
  return {c.coulomb_Nm, c.static_Nm, c.stribeck_speed_rad_s, c.viscous_Nms_rad, matched_lag_s};
}

}  // namespace

FrictionModelEntry hess_soom_model() {
  return model<HessSoomFriction>({.stribeck = true, .lag = true}, hess_soom);
}

}  // namespace tribolog::friction
