// Generalised Maxwell-slip friction (Al-Bender, Lampaert, Swevers 2005).
//
//   element i sticks:  dTi/dt = ki w                                until |Ti| = ai s(w)
//   element i slips:   dTi/dt = sgn(w) C (ai - sgn(w) Ti / s(w))    until w goes through zero
//   T = sum Ti + s2 w
//
// Rate-independent hysteresis with non-local memory in pre-sliding, Stribeck curve and frictional
// lag (by C) in sliding.

#include <cmath>

#include "base/requirements.h"
#include "friction/exponential_step.h"
#include "friction/friction_model.h"
#include "friction/model_entry.h"
#include "friction/sign_change.h"
#include "friction/static_laws.h"

namespace tribolog::friction {
namespace {

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
  /// Sticking exact, the instant of slip by false position, slipping by the exponential step.
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

constexpr double at_limit = 1 - 1e-9;  // a solver stops next to the moment, not on it

ParameterSlots GmsFriction::Parameters::by_name() {
  return joined({ParameterSlots{{"elements", &elements}}, curve.by_name(),
                 ParameterSlots{{"attraction_Nm_s", &attraction_Nm_s},
                                {"viscous_Nms_rad", &viscous_Nms_rad}}});
}

GmsFriction::GmsFriction(const Parameters& parameters) : p_(parameters), curve_(parameters.curve) {
  require_maxwell_elements(p_.elements);
  require_positive(p_.attraction_Nm_s, "attraction", "N·m/s");
  require_not_negative(p_.viscous_Nms_rad, "viscous coefficient", "N·m·s/rad");
}

void GmsFriction::rates(std::span<const double> state, double speed_rad_s,
                        std::span<double> rates) const {
  const std::size_t n = p_.elements.size();
  const double steady = curve_(speed_rad_s);
  for (std::size_t i = 0; i < n; ++i) {
    const MaxwellElement& one = p_.elements[i];
    const double slips = state[n + i];
    rates[i] = slips == 0.0 ? one.stiffness_Nm_rad * speed_rad_s
                            : p_.attraction_Nm_s * (slips * one.share - state[i] / steady);
    rates[n + i] = 0;
  }
}

void GmsFriction::settle(std::span<double> state, double speed_rad_s) const {
  const std::size_t n = p_.elements.size();
  const double direction = direction_of(speed_rad_s);
  const double steady = curve_(speed_rad_s);
  for (std::size_t i = 0; i < n; ++i) {
    double& slips = state[n + i];
    if (slips != direction) slips = 0;
    const double limit = at_limit * p_.elements[i].share * steady;
    if (direction != 0.0 && direction * state[i] >= limit) slips = direction;
  }
}

double GmsFriction::torque_Nm(std::span<const double> state, double speed_rad_s) const {
  double torque = p_.viscous_Nms_rad * speed_rad_s;
  for (std::size_t i = 0; i < p_.elements.size(); ++i) torque += state[i];
  return torque;
}

double GmsFriction::steady_torque_Nm(double speed_rad_s) const {
  return direction_of(speed_rad_s) * curve_(speed_rad_s) + p_.viscous_Nms_rad * speed_rad_s;
}

/// A step and the Stribeck curve at its three speeds, which all elements share.
struct GmsFriction::CurvedStep {
  SpeedStep step;
  double start_Nm, middle_Nm, end_Nm;

  CurvedStep(const SpeedStep& of, const StribeckCurve& curve)
      : step(of),
        start_Nm(curve(of.start_rad_s)),
        middle_Nm(curve(of.middle_rad_s)),
        end_Nm(curve(of.end_rad_s)) {}
};

void GmsFriction::advance(std::span<double> state, const SpeedStep& step) const {
  const double direction = step.direction();
  if (direction == 0.0) return;
  const std::size_t n = p_.elements.size();
  const CurvedStep curved(step, curve_);
  const double path = step.path_rad();
  for (std::size_t i = 0; i < n; ++i) {
    const MaxwellElement& one = p_.elements[i];
    double& torque = state[i];
    double& slips = state[n + i];
    if (slips == direction) {
      slip(torque, one.share, curved);
      continue;
    }
    slips = 0;
    if (direction * (torque + one.stiffness_Nm_rad * path) < one.share * curved.end_Nm) {
      torque += one.stiffness_Nm_rad * path;
      continue;
    }
    const double moment = slip_moment(torque, one, curved);
    torque += one.stiffness_Nm_rad * step.part(0, moment).path_rad();
    slips = direction;
    slip(torque, one.share, CurvedStep(step.part(moment, 1), curve_));
  }
}

double GmsFriction::slip_moment(double torque_Nm, const MaxwellElement& element,
                                const CurvedStep& curved) const {
  const SpeedStep& step = curved.step;
  const double direction = step.direction();
  if (direction * torque_Nm >= element.share * curved.start_Nm) return 0;
  const auto excess = [&](double share) {
    const double way = step.part(0, share).path_rad();
    return direction * (torque_Nm + element.stiffness_Nm_rad * way) -
           element.share * curve_(step.speed_rad_s(share));
  };
  return sign_change(excess, 0.0, 1.0, share_resolution);
}

void GmsFriction::slip(double& torque_Nm, double share, const CurvedStep& curved) const {
  const double c = p_.attraction_Nm_s;
  const double target = curved.step.direction() * share;
  torque_Nm =
      relaxed(relaxation_shape<double>(c / curved.start_Nm, c / curved.middle_Nm, c / curved.end_Nm,
                                       target * curved.start_Nm, target * curved.middle_Nm,
                                       target * curved.end_Nm, curved.step.duration_s),
              torque_Nm);
}

void GmsFriction::state_scales(std::span<double> scales) const {
  const std::size_t n = p_.elements.size();
  for (std::size_t i = 0; i < n; ++i) {
    scales[i] = p_.elements[i].share * p_.curve.coulomb_Nm;
    scales[n + i] = 1;
  }
}

void GmsFriction::event_values(std::span<const double> state, double speed_rad_s,
                               std::span<double> values) const {
  const std::size_t n = p_.elements.size();
  const double steady = curve_(speed_rad_s);
  for (std::size_t i = 0; i < n; ++i) {
    const bool sticks = state[n + i] == 0.0;
    const double limit = p_.elements[i].share * steady;
    values[i] = sticks ? std::abs(state[i]) - limit : steady;
  }
}

/// The attraction gives the same time constant s(w)/C as the lag of lubricated contacts.
GmsFriction::Parameters gms(const ContactParameters& c) {
  return {maxwell_elements(c.stiffness_Nm_rad, c.static_Nm, matched_elements), matched_curve(c),
          c.coulomb_Nm / matched_lag_s, c.viscous_Nms_rad};
}

}  // namespace

FrictionModelEntry gms_model() {
  return model<GmsFriction>({.break_away = true,
                             .stribeck = true,
                             .lag = true,
                             .presliding = true,
                             .non_local_memory = true},
                            gms);
}

}  // namespace tribolog::friction
