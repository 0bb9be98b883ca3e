#include "truth/identified_joint.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/requirements.h"
#include "friction/lugre.h"
#include "friction/static_laws.h"
#include "method/hysteresis/lugre_problem.h"
#include "method/motion/encoder_resolution.h"
#include "method/motion/followed_motion.h"
#include "method/motion/moving_part.h"
#include "method/motion/plateaus.h"
#include "method/viscous/waiboer_fit.h"
#include "simulate/bristle_integrator.h"

namespace tribolog::truth {
namespace {

using method::hysteresis::LuGreParameterName;

/// Sliding friction over the motor's speed, continuous through zero.
class SlidingFriction final : public friction::StaticFriction {
 public:
  SlidingFriction(double coulomb_Nm, double viscous_Nms_rad, double rest_speed_rad_s)
      : coulomb_Nm_(coulomb_Nm), viscous_(viscous_Nms_rad), rest_(rest_speed_rad_s) {}
  [[nodiscard]] std::string name() const override { return "coulomb_viscous"; }
  [[nodiscard]] friction::NamedParameters named_parameters() const override { return {}; }
  [[nodiscard]] double torque_Nm(double speed) const override {
    return coulomb_Nm_ * std::tanh(speed / rest_) + viscous_ * speed;
  }

 private:
  double coulomb_Nm_;
  double viscous_;
  double rest_;
};

/// The law of the model, continuous through zero.
class LawOfRuns final : public friction::StaticFriction {
 public:
  LawOfRuns(const method::model::ModelLaw& law, double rest_speed_rad_s)
      : law_(law), rest_(rest_speed_rad_s) {}
  [[nodiscard]] std::string name() const override { return "model"; }
  [[nodiscard]] friction::NamedParameters named_parameters() const override { return {}; }
  [[nodiscard]] double torque_Nm(double speed) const override {
    return law_.friction_Nm(std::abs(speed)) * std::tanh(speed / rest_);
  }

 private:
  const method::model::ModelLaw& law_;
  double rest_;
};

/// Speeds below this share of the largest are rest: there the sign of friction is nobody's.
constexpr double rest_share = 1e-3;

/// Of the model along a recording; empty: it cannot follow.
struct ModelTorque {
  std::vector<double> whole_Nm;
  std::vector<double> friction_Nm;
  ModelTorque() = default;
  explicit ModelTorque(std::size_t size) : whole_Nm(size), friction_Nm(size) {}
};

class Maker {
 public:
  /// Friction of the law that points follow; empty without one.
  [[nodiscard]] std::vector<double> friction_at(const std::vector<double>& speed_rad_s) const {
    const method::selection::FrictionParametersResult& f = c_.friction;
    const auto torques = [&](const friction::StaticFriction& law) {
      std::vector<double> out;
      for (const double speed : speed_rad_s) out.push_back(law.torque_Nm(speed));
      return out;
    };
    constexpr double at_once = 1e-9;
    if (runs_follow_waiboer(c_)) return torques(present(method::viscous::waiboer_of(f.waiboer)));
    if (!c_.model.law.empty()) return torques(LawOfRuns(c_.model.law, at_once));
    return {};
  }

  Maker(const calibration::Calibration& calibration, double gravity_Nm)
      : c_(calibration), n_(calibration.manifest.drive.gear_ratio()), gravity_Nm_(gravity_Nm) {}

  /// Torque of the model along a recording; empty if the model cannot follow, with the reason.
  [[nodiscard]] ModelTorque torque(const joint::Recording& r, Statement& why_not) const {
    switch (r.role) {
      case joint::Role::rough_sweep:
        return sweep_torque(r, c_.rough, why_not);
      case joint::Role::precise_sweep:
        return sweep_torque(r, c_.precise, why_not);
      case joint::Role::oscillation:
        return loop_torque(r, why_not);
      case joint::Role::break_away:
        why_not = {"truth.ramp_is_its_answer"};
        return {};
      case joint::Role::constant_speed:
      case joint::Role::friction_points:
        break;
    }
    return run_torque(r, why_not);
  }

 private:
  [[nodiscard]] double gravity(double q, double middle) const {
    return gravity_Nm_ * std::cos(q - (c_.q_peak_rad ? c_.q_peak_rad->value : middle));
  }

  [[nodiscard]] ModelTorque sliding(const joint::Recording& r,
                                    const method::motion::MotionSegments& motion,
                                    const friction::StaticFriction& friction, double offset_Nm,
                                    double inertia_kgm2) const {
    ModelTorque torque(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) {
      torque.friction_Nm[i] = friction.torque_Nm(n_ * motion.speed_rad_s[i]);
      torque.whole_Nm[i] = gravity(r.q_rad[i], r.q_rad[i]) + offset_Nm + torque.friction_Nm[i] +
                           inertia_kgm2 * n_ * motion.acceleration_rad_s2[i];
    }
    return torque;
  }

  [[nodiscard]] double rest_speed(const method::motion::MotionSegments& motion) const {
    return std::max(1e-9, rest_share * n_ * motion.fastest_rad_s);
  }

  [[nodiscard]] ModelTorque sweep_torque(const joint::Recording& r,
                                         const method::gravity::CogSweepResult& sweep,
                                         Statement& why_not) const {
    if (!sweep.found) {
      why_not = {"truth.sweep_without_gravity"};
      return {};
    }
    // One direction alone cannot tell friction from an offset; the level of both is in the mean.
    const double coulomb = sweep.coulomb_Nm ? sweep.coulomb_Nm->value : 0.0;
    const double viscous = sweep.viscous_Nms_rad ? sweep.viscous_Nms_rad->value : 0.0;
    const double inertia = sweep.inertia_kgm2 ? sweep.inertia_kgm2->value : 0.0;
    const method::motion::MotionSegments motion = method::motion::find_plateaus(r);
    const SlidingFriction friction(coulomb, viscous, rest_speed(motion));
    const method::model::ModelEffect* offset = c_.model.find(joint::effect::offset.key);
    const double offset_Nm =
        offset != nullptr && offset->coefficient ? offset->coefficient->value : sweep.offset_Nm;
    ModelTorque torque = sliding(r, motion, friction, offset_Nm, inertia);
    if (inertia != 0) sharpen_inertia(r, motion, inertia, torque);
    return torque;
  }

  /// Local slopes round the corners of the speed, where a joint's inertia acts: by a spline along
  /// the angle, where there is one.
  void sharpen_inertia(const joint::Recording& r, const method::motion::MotionSegments& motion,
                       double inertia_kgm2, ModelTorque& torque) const {
    const method::motion::MotionTrace trace = method::motion::trace_motion(r);
    if (!trace.motion) return;
    const std::unique_ptr<simulate::Motion> motor = trace.motion->motor_motion(n_);
    for (std::size_t i = 0; i < r.size(); ++i) {
      torque.whole_Nm[i] += inertia_kgm2 * (motor->acceleration(r.t_s[i] - r.t_s.front()) -
                                            n_ * motion.acceleration_rad_s2[i]);
    }
  }

  [[nodiscard]] ModelTorque run_torque(const joint::Recording& r, Statement& why_not) const {
    const method::selection::FrictionParametersResult& f = c_.friction;
    if (runs_follow_waiboer(c_)) {
      return sliding(r, method::motion::find_plateaus(r),
                     present(method::viscous::waiboer_of(f.waiboer)), 0, 0);
    }
    if (!c_.model.law.empty()) {
      const method::motion::MotionSegments motion = method::motion::find_plateaus(r);
      return sliding(r, motion, LawOfRuns(c_.model.law, rest_speed(motion)), 0, 0);
    }
    why_not = {"truth.no_curve"};
    return {};
  }

  [[nodiscard]] ModelTorque loop_torque(const joint::Recording& r, Statement& why_not) const {
    if (!c_.lugre || !c_.lugre->converged) {
      why_not = {"truth.no_loop_model"};
      return {};
    }
    const method::motion::FollowedMotion followed =
        method::motion::follow_the_angle(r, method::motion::common_step(r.q_rad));
    if (!followed.harmonic && !followed.traced) {
      why_not = {"truth.no_whole_cycle", {{"why", followed.why_not_traced}}};
      return {};
    }
    const method::hysteresis::LuGreFit& fit = *c_.lugre;
    const auto stiffness = fit.shown(LuGreParameterName::bristle_stiffness);
    const auto level = fit.shown(LuGreParameterName::static_torque);
    if (!stiffness || !level) {
      why_not = {"truth.loop_parameters_not_shown"};
      return {};
    }
    // What they do not show stays out; neither damping may push.
    const auto size_of = [&](LuGreParameterName name) {
      const auto shown = fit.shown(name);
      return shown ? std::max(0.0, shown->value) : 0.0;
    };
    const auto coulomb = fit.shown(LuGreParameterName::coulomb_torque);
    const auto stribeck = fit.shown(LuGreParameterName::stribeck_speed);
    const bool weakens = coulomb && stribeck && coulomb->value < level->value;
    const friction::LuGreFriction friction(
        {stiffness->value, size_of(LuGreParameterName::bristle_damping),
         size_of(LuGreParameterName::viscous), weakens ? coulomb->value : level->value,
         level->value, weakens ? stribeck->value : 1.0});
    const double inertia = size_of(LuGreParameterName::inertia);
    const method::hysteresis::LuGreInput input{&r,
                                               followed.harmonic ? &*followed.harmonic : nullptr,
                                               followed.traced ? &*followed.traced : nullptr};
    const std::shared_ptr<const simulate::Motion> along = input.motor_motion(n_);
    const simulate::Motion& motor = *along;
    const double dt = (r.t_s.back() - r.t_s.front()) / static_cast<double>(r.size() - 1);
    std::vector<double> z(r.size());
    std::vector<double> dz(r.size());
    simulate::integrate_bristle(friction, motor, 0.0, dt, start_deflection(r), z, dz);
    ModelTorque torque(r.size());
    for (std::size_t i = 0; i < r.size(); ++i) {
      // A clock that jitters: between the two instants of the even grid around it.
      const double t = r.t_s[i] - r.t_s.front();
      const auto k = std::min(static_cast<std::size_t>(t / dt), r.size() - 2);
      const double x = t / dt - static_cast<double>(k);
      const double z_t = z[k] + x * (z[k + 1] - z[k]);
      const double dz_t = dz[k] + x * (dz[k + 1] - dz[k]);
      torque.friction_Nm[i] = friction.torque_Nm(z_t, dz_t, motor.speed(t));
      torque.whole_Nm[i] = gravity(r.q_rad[i], input.centre_rad()) + torque.friction_Nm[i] +
                           inertia * motor.acceleration(t);
    }
    return torque;
  }

  /// Of the loop's own bristle where it was observed, else of an unloaded contact.
  [[nodiscard]] double start_deflection(const joint::Recording& r) const {
    for (const method::hysteresis::LoopTrace& trace : c_.curves.loops) {
      if (trace.recording == r.name && !trace.z_rad.empty()) return trace.z_rad.front();
    }
    return 0;
  }

  const calibration::Calibration& c_;
  double n_;
  double gravity_Nm_;
};

/// The recordings that a reading comes from.
bool is_read_from(const Reading& reading, joint::Role role) {
  switch (reading.quantity) {
    case ReadingKind::peak_angle:
      return role == joint::Role::rough_sweep || role == joint::Role::precise_sweep;
    case ReadingKind::sweep_friction:
      return role == joint::Role::rough_sweep;
    case ReadingKind::gravity:
      return reading.name == ReadingName::model ? role != joint::Role::oscillation
                                                : role == joint::Role::oscillation;
    case ReadingKind::stiffness:
    case ReadingKind::static_torque:
      return role == joint::Role::oscillation;
    default:
      return role == joint::Role::constant_speed;
  }
}

/// Of the identified readings those that the model was made with and that its recordings can show.
std::vector<Reading> put_in(const calibration::Calibration& c, double gravity_Nm,
                            const joint::Dataset& dataset) {
  const std::vector<joint::Recording>& recordings = dataset.recordings;
  std::vector<Reading> kept;
  for (Reading reading : readings_of(c)) {
    const bool is_recorded =
        std::any_of(recordings.begin(), recordings.end(),
                    [&](const joint::Recording& r) { return is_read_from(reading, r.role); }) ||
        (!dataset.friction_points.empty() && is_read_from(reading, joint::Role::constant_speed));
    if (!is_recorded || is_single_point(reading.name)) continue;
    // Where eq. (6) is put in, no other law is, and the other way round.
    using enum ReadingKind;
    const ReadingKind kind = reading.quantity;
    const bool is_of_law = kind == coulomb || kind == viscous;
    const bool is_of_waiboer = kind == asperity_torque || kind == stribeck_power ||
                               kind == viscous_factor || kind == viscous_power;
    if (is_of_law && (c.viscous.from_sweep || runs_follow_waiboer(c))) continue;
    if (is_of_waiboer && !runs_follow_waiboer(c)) continue;
    const double value =
        reading.quantity == ReadingKind::gravity ? gravity_Nm : reading.estimate.value;
    reading.estimate = {value, value, value, {"interval.put_in"}};
    kept.push_back(std::move(reading));
  }
  return kept;
}

/// Of a recording so long that repeating it would take longer than the identification itself, what
/// shows as much: an oscillation's first cycles, of any other every so many samples.
joint::Recording shortened(const joint::Recording& r) {
  constexpr std::size_t long_from = 200'000;
  constexpr std::size_t enough = 50'000;
  if (r.size() < long_from) return r;
  const std::size_t stride = r.role == joint::Role::oscillation ? 1 : r.size() / enough;
  const auto picked = [&](const std::vector<double>& whole) {
    std::vector<double> out;
    for (std::size_t i = 0; i < whole.size() && out.size() < enough; i += stride) {
      out.push_back(whole[i]);
    }
    return out;
  };
  joint::Recording out;
  out.name = r.name;
  out.role = r.role;
  out.t_s = picked(r.t_s);
  out.q_rad = picked(r.q_rad);
  out.dq_rad_s = picked(r.dq_rad_s);
  out.torque_Nm = picked(r.torque_Nm);
  out.temperature_C = picked(r.temperature_C);
  return out;
}

}  // namespace

IdentifiedJoint identified_joint(const joint::Dataset& dataset, const calibration::Calibration& c) {
  IdentifiedJoint out;
  out.dataset.manifest = dataset.manifest;
  const method::hysteresis::SurrogateMass* mass = c.masses.find(c.selection.recommended);
  if (mass == nullptr) {
    out.left_out.push_back({"truth.nothing_to_simulate"});
    return out;
  }
  const double gravity = mass->gravity_Nm.value;
  const Maker maker(c, gravity);
  for (const joint::Recording& recorded : dataset.recordings) {
    const joint::Recording whole = recorded.role == joint::Role::oscillation
                                       ? method::motion::moving_part(recorded)
                                       : recorded;
    joint::Recording r = shortened(whole);
    Statement why_not;
    ModelTorque torque = r.size() < 4 ? ModelTorque{} : maker.torque(r, why_not);
    if (torque.whole_Nm.empty()) {
      if (why_not.empty()) why_not = {"truth.too_few_samples"};
      out.left_out.push_back({"truth.not_simulated", {{"recording", r.name}, {"why", why_not}}});
      continue;
    }
    const double step = method::motion::common_step(whole.torque_Nm);
    // A rounded number is uniform within its step: that part comes back with the rounding.
    const double rounding = step / std::sqrt(12.0);
    const double white = white_torque_Nm(whole.torque_Nm);
    out.white_Nm.push_back(std::sqrt(std::max(0.0, white * white - rounding * rounding)));
    out.torque_step_Nm.push_back(step);
    if (r.size() < whole.size()) {
      const Code shortened_to = r.role == joint::Role::oscillation
                                    ? Code{"truth.first_samples_simulated"}
                                    : Code{"truth.spread_samples_simulated"};
      out.left_out.push_back(
          {shortened_to, {{"recording", r.name}, {"samples", r.size()}, {"all", whole.size()}}});
    }
    r.torque_Nm = std::move(torque.whole_Nm);
    out.friction_Nm.push_back(std::move(torque.friction_Nm));
    r.z_rad.clear();
    r.dz_rad_s.clear();
    out.dataset.recordings.push_back(std::move(r));
  }
  for (const joint::FrictionPoints& points : dataset.friction_points) {
    joint::FrictionPoints simulated = points;
    simulated.torque_Nm = maker.friction_at(points.speed_rad_s);
    if (simulated.torque_Nm.empty()) {
      out.left_out.push_back({"truth.not_simulated",
                              {{"recording", points.name}, {"why", Statement{"truth.no_curve"}}}});
      continue;
    }
    simulated.load_Nm.clear();  // its part is not in the law
    double squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      squares += std::pow(points.torque_Nm[i] - simulated.torque_Nm[i], 2);
    }
    out.scatter_of_points_Nm.push_back(std::sqrt(squares / static_cast<double>(points.size())));
    out.dataset.friction_points.push_back(std::move(simulated));
  }
  out.ripple = ripple_of(dataset, c.rough, c.curves.rough);
  out.put_in = put_in(c, gravity, out.dataset);
  if (const auto waiboer = method::viscous::waiboer_of(c.friction.waiboer);
      dataset.manifest.reference && waiboer) {
    out.dataset.manifest.reference = std::make_shared<friction::WaiboerFriction>(*waiboer);
  }
  return out;
}

}  // namespace tribolog::truth
