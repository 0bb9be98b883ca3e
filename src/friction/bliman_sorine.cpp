// Friction of Bliman and Sorine (1991, 1995): a linear system in the distance travelled.
//
//   dx1/ds = -x1/(eta e) + f1/(eta e) sgn(w)
//   dx2/ds = -x2/e       - f2/e       sgn(w)
//   T = x1 + x2,    s = integral of |w| dt
//
// Rate independent. The faster part x1 rises to f1 over the distance eta e, the slower one pulls
// back by f2 over e: before it settles at the Coulomb torque f1 - f2 the torque passes through a
// peak, which is how the second-order model shows break-away.

#include <cmath>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"

namespace tribolog::friction {
namespace {

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
  /// Largest torque [N·m] between an unloaded contact and steady sliding.
  [[nodiscard]] double break_away_Nm() const;

  [[nodiscard]] std::size_t states() const override { return 2; }
  void state_scales(std::span<double> scales) const override;
  void rates(std::span<const double> state, double speed_rad_s,
             std::span<double> rates) const override;
  [[nodiscard]] double torque_Nm(std::span<const double> state, double speed_rad_s) const override;
  [[nodiscard]] double steady_torque_Nm(double speed_rad_s) const override;
  /// Exact for any speed profile.
  void advance(std::span<double> state, const SpeedStep& step) const override;

 private:
  Parameters p_;
};

ParameterSlots BlimanSorineFriction::Parameters::by_name() {
  return {{"fast_torque_Nm", &fast_torque_Nm},
          {"slow_torque_Nm", &slow_torque_Nm},
          {"slow_way_rad", &slow_way_rad},
          {"way_ratio", &way_ratio, true},
          {"viscous_Nms_rad", &viscous_Nms_rad}};
}

BlimanSorineFriction::BlimanSorineFriction(const Parameters& parameters) : p_(parameters) {
  require_positive(p_.fast_torque_Nm, "torque f1", "N·m");
  require_not_negative(p_.slow_torque_Nm, "torque f2", "N·m");
  require_positive(p_.slow_way_rad, Code{"parameter.slow_way"}, "rad");
  require_positive(p_.way_ratio, Code{"parameter.way_ratio"}, "");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  if (p_.slow_torque_Nm >= p_.fast_torque_Nm) {
    throw Refusal({"bliman_sorine.slow_torque_not_below_fast",
                   {{"slow_Nm", p_.slow_torque_Nm}, {"fast_Nm", p_.fast_torque_Nm}}});
  }
  if (p_.way_ratio >= 1) {
    throw Refusal({"bliman_sorine.way_ratio_not_below_one", {{"ratio", p_.way_ratio}}});
  }
}

// T(s) = f1 (1 - exp(-s/(eta e))) - f2 (1 - exp(-s/e)) is largest where its slope is zero.
double BlimanSorineFriction::break_away_Nm() const {
  const double f1 = p_.fast_torque_Nm;
  const double f2 = p_.slow_torque_Nm;
  const double eta = p_.way_ratio;
  if (f2 == 0.0) return f1;
  const double s = std::log(f1 / (eta * f2)) * eta / (1 - eta);  // in units of e
  return f1 * -std::expm1(-s / eta) - f2 * -std::expm1(-s);
}

void BlimanSorineFriction::rates(std::span<const double> state, double speed_rad_s,
                                 std::span<double> rates) const {
  const double slow = 1 / p_.slow_way_rad;
  const double fast = slow / p_.way_ratio;
  rates[0] = fast * (p_.fast_torque_Nm * speed_rad_s - state[0] * std::abs(speed_rad_s));
  rates[1] = slow * (-p_.slow_torque_Nm * speed_rad_s - state[1] * std::abs(speed_rad_s));
}

double BlimanSorineFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  return state[0] + state[1] + p_.viscous_Nms_rad * speed_rad_s;
}

double BlimanSorineFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * (p_.fast_torque_Nm - p_.slow_torque_Nm) + p_.viscous_Nms_rad * speed_rad_s;
}

void BlimanSorineFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  const double way = std::abs(step.path_rad()) / p_.slow_way_rad;
  const double end1 = direction * p_.fast_torque_Nm;
  const double end2 = -direction * p_.slow_torque_Nm;
  state[0] = end1 + (state[0] - end1) * std::exp(-way / p_.way_ratio);
  state[1] = end2 + (state[1] - end2) * std::exp(-way);
}

void BlimanSorineFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.fast_torque_Nm;
  scales[1] = p_.fast_torque_Nm;
}

/// f1 and f2 such that the peak is the break-away torque; the initial stiffness then sets the
/// distances.
BlimanSorineFriction::Parameters bliman_sorine(const ContactParameters& c) {
  constexpr double eta = 0.5;
  const auto with = [&](double slow) {
    const double fast = c.coulomb_Nm + slow;
    const double way = (fast / eta - slow) / c.stiffness_Nm_rad;
    return BlimanSorineFriction::Parameters{fast, slow, way, eta, c.viscous_Nms_rad};
  };
  double low = 0;
  double high = 100 * c.static_Nm;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    const bool too_small = BlimanSorineFriction(with(middle)).break_away_Nm() < c.static_Nm;
    (too_small ? low : high) = middle;
  }
  return with((low + high) / 2);
}

}  // namespace

FrictionModelEntry bliman_sorine_model() {
  return model<BlimanSorineFriction>(
      {.break_away = true, .presliding = true, .drifts = true, .rate_independent = true},
      bliman_sorine);
}

}  // namespace tribolog::friction
