// Elasto-plastic friction (Dupont, Hayward, Armstrong, Altpeter 2002): LuGre without its drift.
//
//   dz/dt = w (1 - a(z, w) sgn(w) z / g(w)),     s0 g(w) = s(w)
//   T = s0 z + s1 dz/dt + s2 w
//
// a = 0 while |z| <= zba or z is against the motion: the bristle is purely elastic and comes back
// to where it was. From zba to g(w) a rises to 1 along a sine; at 1 this is LuGre.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/requirements.h"
#include "base/statement.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"
#include "friction/relaxation.h"
#include "friction/sign_change.h"
#include "friction/static_laws.h"

namespace tribolog::friction {
namespace {

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

/// cos(x) for 0 <= x <= pi/2 by its series, within 1e-15: std::cos takes several times as long, and
/// half of all time went into it.
double cosine(double x) {
  const double y = x * x;
  const double y2 = y * y;
  const double y4 = y2 * y2;
  const double low = (1.0 - y * 0.5) + (1.0 / 24 - y * (1.0 / 720)) * y2;
  const double middle =
      (1.0 / 40320 - y * (1.0 / 3628800)) + (1.0 / 479001600 - y * (1.0 / 87178291200)) * y2;
  const double high = 1.0 / 20922789888000 - y * (1.0 / 6402373705728000);
  return low + (middle + high * y4) * y4;
}

ParameterSlots ElastoPlasticFriction::Parameters::by_name() {
  return joined({ParameterSlots{{"bristle_stiffness_Nm_rad", &bristle_stiffness_Nm_rad},
                                {"bristle_damping_Nms_rad", &bristle_damping_Nms_rad},
                                {"viscous_Nms_rad", &viscous_Nms_rad}},
                 curve.by_name(),
                 ParameterSlots{{"break_away_deflection_rad", &break_away_deflection_rad}}});
}

ElastoPlasticFriction::ElastoPlasticFriction(const Parameters& parameters)
    : p_(parameters),
      curve_(parameters.curve),
      compliance_rad_Nm_(1 / parameters.bristle_stiffness_Nm_rad) {
  require_positive(p_.bristle_stiffness_Nm_rad, "bristle stiffness", "N·m/rad");
  require_not_negative(p_.bristle_damping_Nms_rad, "bristle damping", "N·m·s/rad");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
  require_positive(p_.break_away_deflection_rad, "break-away deflection", "rad");
  const double least = p_.curve.coulomb_Nm / p_.bristle_stiffness_Nm_rad;
  if (p_.break_away_deflection_rad >= least) {
    throw Refusal({"elasto_plastic.break_away_not_below_coulomb",
                   {{"deflection_rad", p_.break_away_deflection_rad}, {"coulomb_rad", least}}});
  }
}

ElastoPlasticFriction::SteadyDeflection ElastoPlasticFriction::steady_deflection(
    double speed_rad_s) const {
  const double g = curve_(speed_rad_s) * compliance_rad_Nm_;
  return {g, 1 / (g - p_.break_away_deflection_rad)};
}

double ElastoPlasticFriction::elastic_share(double deflection_rad,
                                            const SteadyDeflection& g) const {
  const double elastic = p_.break_away_deflection_rad;
  if (deflection_rad <= elastic) return 1;
  if (deflection_rad >= g.rad) return 0;
  const double risen = (deflection_rad - elastic) * g.per_way_to_it;
  const double root = cosine(std::numbers::pi / 2 * risen);
  return root * root;
}

double ElastoPlasticFriction::rate_rad_s(double z_rad, double speed_rad_s,
                                         const SteadyDeflection& g) const {
  const double along = speed_rad_s < 0 ? -z_rad : z_rad;
  return speed_rad_s * (1 - (1 - elastic_share(along, g)) * along / g.rad);
}

double ElastoPlasticFriction::torque_Nm(double z_rad, double speed_rad_s,
                                        const SteadyDeflection& g) const {
  return p_.bristle_stiffness_Nm_rad * z_rad +
         p_.bristle_damping_Nms_rad * rate_rad_s(z_rad, speed_rad_s, g) +
         p_.viscous_Nms_rad * speed_rad_s;
}

void ElastoPlasticFriction::rates(std::span<const double> state, double speed_rad_s,
                                  std::span<double> rates) const {
  rates[0] = rate_rad_s(state[0], speed_rad_s, steady_deflection(speed_rad_s));
}

double ElastoPlasticFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  return torque_Nm(state[0], speed_rad_s, steady_deflection(speed_rad_s));
}

double ElastoPlasticFriction::steady_torque_Nm(double speed_rad_s) const {
  const double sign = direction_of(speed_rad_s);
  return sign * curve_(speed_rad_s) + p_.viscous_Nms_rad * speed_rad_s;
}

/// In the direction of motion: LuGre's equation with the elastic share of z as a further target.
struct ElastoPlasticFriction::Bending {
  const ElastoPlasticFriction& friction;
  struct Node {
    double rate;
    SteadyDeflection g;
  };
  [[nodiscard]] Node at(double speed) const {
    const SteadyDeflection g = friction.steady_deflection(speed);
    return {std::abs(speed) / g.rad, g};
  }
  [[nodiscard]] double target(const Node& node, double z) const {
    return node.g.rad + friction.elastic_share(z, node.g) * z;
  }
};

void ElastoPlasticFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const double way = std::abs(step.path_rad());
  const double start = direction * state[0];
  const double elastic_way = p_.break_away_deflection_rad - start;
  if (way <= elastic_way) {
    state[0] = direction * (start + way);
    return;
  }
  double begin = start;
  SpeedStep bending_part = step;
  if (elastic_way > 0) {
    const double share = sign_change(
        [&](double until) { return std::abs(step.part(0, until).path_rad()) - elastic_way; }, 0.0,
        1.0, share_resolution);
    bending_part = step.part(share, 1);
    begin = p_.break_away_deflection_rad;
  }
  const Bending bending{*this};
  const double size = p_.curve.coulomb_Nm / p_.bristle_stiffness_Nm_rad;
  state[0] = direction * Relaxation(bending, size).advance(bending_part, begin);
}

void ElastoPlasticFriction::respond(std::span<double> state, std::span<const SpeedStep> steps,
                                    std::span<double> torque_Nm) const {
  if (steps.empty()) return;
  const Bending bending{*this};
  const Relaxation relaxation(bending, p_.curve.coulomb_Nm / p_.bristle_stiffness_Nm_rad);
  Bending::Node start = bending.at(steps[0].start_rad_s);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const SpeedStep& step = steps[i];
    const Bending::Node last = bending.at(step.end_rad_s);
    const double direction = step.direction();
    const double along = direction * state[0];
    const bool is_bending = direction != 0.0 && along >= p_.break_away_deflection_rad;
    if (is_bending && i + 1 < steps.size() && steps[i + 1].direction() == direction &&
        steps[i + 1].duration_s == step.duration_s) {
      const SpeedStep& next = steps[i + 1];
      const Bending::Node after = bending.at(next.end_rad_s);
      if (const auto pair =
              relaxation.advance_pair(2 * step.duration_s, along, start, last, after)) {
        torque_Nm[i] = this->torque_Nm(direction * pair->middle, step.end_rad_s, last.g);
        state[0] = direction * pair->end;
        torque_Nm[i + 1] = this->torque_Nm(state[0], next.end_rad_s, after.g);
        start = after;
        ++i;
        continue;
      }
    }
    if (is_bending) {
      state[0] = direction * relaxation.advance(step, along, start, last);
    } else {
      advance(state, step);
    }
    torque_Nm[i] = this->torque_Nm(state[0], step.end_rad_s, last.g);
    start = last;
  }
}

void ElastoPlasticFriction::state_scales(std::span<double> scales) const {
  scales[0] = p_.curve.coulomb_Nm / p_.bristle_stiffness_Nm_rad;
}

ElastoPlasticFriction::Parameters elasto_plastic(const ContactParameters& c) {
  return {c.stiffness_Nm_rad, c.damping_Nms_rad, c.viscous_Nms_rad, matched_curve(c),
          0.7 * c.coulomb_Nm / c.stiffness_Nm_rad};
}

}  // namespace

FrictionModelEntry elasto_plastic_model() {
  return model<ElastoPlasticFriction>(
      {.break_away = true, .stribeck = true, .lag = true, .presliding = true}, elasto_plastic);
}

}  // namespace tribolog::friction
