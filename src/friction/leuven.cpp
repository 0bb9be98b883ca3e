// The Leuven integrated model (Swevers, Al-Bender, Ganseman, Prajogo 2000), with its hysteresis
// torque from Maxwell-slip elements, as Lampaert, Swevers and Al-Bender (2002) introduced them to
// remove the original's jump where an inner loop closes.
//
//   dz/dt = w (1 - sgn(w) sgn(Th) |Th(z) / s(w)|^n)
//   T = Th(z) + s1 dz/dt + s2 w
//
// Th(z): torque of the elements at the deflection z, with non-local memory: an inner loop closes
// where it was left. In sliding Th -> s(w).

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"
#include "friction/relaxation.h"
#include "friction/sign_change.h"
#include "friction/static_laws.h"

namespace tribolog::friction {
namespace {

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
  /// By exponential steps of 4th order, cut where an element reaches its limit or z reverses
  /// (towards a falling s).
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
  /// Advances until the next element reaches its limit or z reverses; returns when, as a share of
  /// the step.
  /// @param way 1 while z moves with the motion, -1 against it; changed where z reverses.
  double advance_until_change(std::span<double> state, const SpeedStep& step, double& way) const;

  Parameters p_;
  StribeckCurve curve_;
  double stiffness_Nm_rad_{};
};

ParameterSlots LeuvenFriction::Parameters::by_name() {
  return joined({ParameterSlots{{"elements", &elements}}, curve.by_name(),
                 ParameterSlots{{"transition_power", &transition_power, true},
                                {"micro_damping_Nms_rad", &micro_damping_Nms_rad},
                                {"viscous_Nms_rad", &viscous_Nms_rad}}});
}

LeuvenFriction::LeuvenFriction(const Parameters& parameters)
    : p_(parameters), curve_(parameters.curve) {
  require_maxwell_elements(p_.elements);
  require_not_negative(p_.micro_damping_Nms_rad, "micro-viscous damping", "N·m·s/rad");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  if (!(p_.transition_power >= 1)) {
    throw Refusal({"leuven.transition_power_below_one", {{"power", p_.transition_power}}});
  }
  for (const MaxwellElement& one : p_.elements) stiffness_Nm_rad_ += one.stiffness_Nm_rad;
}

double LeuvenFriction::limit_Nm(std::size_t element) const {
  return reserve * p_.curve.static_Nm * p_.elements[element].share;
}

double LeuvenFriction::hysteresis_Nm(std::span<const double> state) const {
  double sum = 0;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const double limit = limit_Nm(i);
    sum += std::clamp(state[1 + i], -limit, limit);
  }
  return sum;
}

double LeuvenFriction::to_transition_power(double ratio) const {
  const double n = p_.transition_power;
  if (n == 2.0) return ratio * ratio;
  if (n == 4.0) return ratio * ratio * ratio * ratio;
  return std::pow(ratio, n);
}

double LeuvenFriction::slope(double hysteresis_Nm, double speed_rad_s) const {
  const double ratio = hysteresis_Nm / curve_(speed_rad_s);
  const double size = to_transition_power(std::abs(ratio));
  return 1 - direction_of(speed_rad_s) * std::copysign(size, ratio);
}

void LeuvenFriction::rates(std::span<const double> state, double speed_rad_s,
                           std::span<double> rates) const {
  const double rate = speed_rad_s * slope(hysteresis_Nm(state), speed_rad_s);
  rates[0] = rate;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const bool is_at_limit = std::abs(state[1 + i]) >= limit_Nm(i) && state[1 + i] * rate > 0;
    rates[1 + i] = is_at_limit ? 0.0 : p_.elements[i].stiffness_Nm_rad * rate;
  }
}

void LeuvenFriction::settle(std::span<double> state, double /*speed_rad_s*/) const {
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const double limit = limit_Nm(i);
    state[1 + i] = std::clamp(state[1 + i], -limit, limit);
  }
}

double LeuvenFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  const double hysteresis = hysteresis_Nm(state);
  const double rate = speed_rad_s * slope(hysteresis, speed_rad_s);
  return hysteresis + p_.micro_damping_Nms_rad * rate + p_.viscous_Nms_rad * speed_rad_s;
}

double LeuvenFriction::steady_torque_Nm(double speed_rad_s) const {
  return direction_of(speed_rad_s) * curve_(speed_rad_s) + p_.viscous_Nms_rad * speed_rad_s;
}

/// While no element reaches its limit: Th, counted in the direction of motion, relaxes towards
/// s(w).
struct LeuvenFriction::Relaxing {
  const LeuvenFriction& friction;
  double stiffness_Nm_rad;  ///< Of the elements that give way.
  struct Node {
    double rate, steady_Nm, per_steady;
  };
  [[nodiscard]] Node at(double speed) const {
    const double s = friction.curve_(speed);
    const double per_steady = 1 / s;
    const double n = friction.p_.transition_power;
    return {n * stiffness_Nm_rad * std::abs(speed) * per_steady, s, per_steady};
  }
  [[nodiscard]] double target(const Node& node, double hysteresis) const {
    const double u = hysteresis * node.per_steady;
    const double power = std::copysign(friction.to_transition_power(std::abs(u)), u);
    return hysteresis + (1 - power) * node.steady_Nm / friction.p_.transition_power;
  }
};

/// The elements that a deflection in one direction stretches: those that are not at their limit.
struct LeuvenFriction::Stretching {
  double stiffness_Nm_rad{};
  double room_rad{std::numeric_limits<double>::infinity()};  ///< Until the next one is.
};

LeuvenFriction::Stretching LeuvenFriction::stretching(std::span<const double> state,
                                                      double direction) const {
  Stretching out;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const double left = limit_Nm(i) - direction * state[1 + i];
    if (left <= 0) continue;
    out.stiffness_Nm_rad += p_.elements[i].stiffness_Nm_rad;
    out.room_rad = std::min(out.room_rad, left / p_.elements[i].stiffness_Nm_rad);
  }
  return out;
}

void LeuvenFriction::stretch(std::span<double> state, double further_rad) const {
  state[0] += further_rad;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    const double limit = limit_Nm(i);
    state[1 + i] =
        std::clamp(state[1 + i] + p_.elements[i].stiffness_Nm_rad * further_rad, -limit, limit);
  }
}

double LeuvenFriction::advance_until_change(std::span<double> state, const SpeedStep& step,
                                            double& way) const {
  const double direction = step.direction();
  const double start = direction * hysteresis_Nm(state);
  const Stretching s = stretching(state, direction * way);
  const Relaxing relaxing{*this, s.stiffness_Nm_rad};
  const Relaxation relaxation(relaxing, p_.curve.coulomb_Nm);
  const auto at = [&](double share) {
    return share > 0 ? relaxation.advance(step.part(0, share), start) : start;
  };
  const auto beyond_room = [&](double hysteresis) {
    return way * (hysteresis - start) - s.stiffness_Nm_rad * s.room_rad;
  };
  const auto turned = [&](double hysteresis, double share) {
    return way * (hysteresis - curve_(step.speed_rad_s(share)));
  };
  const double end = at(1);
  if (beyond_room(end) > 0) {
    stretch(state, direction * way * s.room_rad);
    return sign_change([&](double share) { return beyond_room(at(share)); }, 0.0, 1.0,
                       share_resolution);
  }
  const double noise = 1e-9 * p_.curve.coulomb_Nm;  // in steady sliding z neither goes nor turns
  if (turned(start, 0) < -noise && turned(end, 1) > noise) {
    const double share = sign_change([&](double until) { return turned(at(until), until); }, 0.0,
                                     1.0, share_resolution);
    stretch(state, direction * (at(share) - start) / s.stiffness_Nm_rad);
    way = -way;
    return share;
  }
  stretch(state, direction * (end - start) / s.stiffness_Nm_rad);
  return 1;
}

void LeuvenFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const bool falls_short = direction * hysteresis_Nm(state) <= curve_(step.start_rad_s);
  double way = falls_short ? 1.0 : -1.0;
  SpeedStep rest = step;
  for (double done = 0; done < 1;) {
    done = advance_until_change(state, rest, way);
    if (done < 1) rest = rest.part(done, 1);
  }
}

void LeuvenFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.curve.coulomb_Nm / stiffness_Nm_rad_;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    scales[1 + i] = p_.elements[i].share * p_.curve.coulomb_Nm;
  }
}

void LeuvenFriction::event_values(std::span<const double> state, double /*speed_rad_s*/,
                                  std::span<double> values) const {
  for (std::size_t i = 0; i < p_.elements.size(); ++i) {
    values[i] = std::abs(state[1 + i]) - limit_Nm(i);
  }
}

LeuvenFriction::Parameters leuven(const ContactParameters& c) {
  return {
      maxwell_elements(c.stiffness_Nm_rad, LeuvenFriction::reserve * c.static_Nm, matched_elements),
      matched_curve(c), 4.0, c.damping_Nms_rad, c.viscous_Nms_rad};
}

}  // namespace

FrictionModelEntry leuven_model() {
  return model<LeuvenFriction>({.break_away = true,
                                .stribeck = true,
                                .lag = true,
                                .presliding = true,
                                .non_local_memory = true,
                                .drifts = true},
                               leuven);
}

}  // namespace tribolog::friction
