#include "method/hysteresis/surrogate_masses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/requirements.h"
#include "joint/degrees.h"
#include "joint/gravity_load.h"

namespace tribolog::method::hysteresis {
namespace {

struct Context {
  std::optional<double> q_peak_rad;
  double q_peak_half_width{};
  double gear_ratio{};
  double distance_m{};
  double gravity_m_s2{};
};

/// The offset of the model, where it is known well enough to be subtracted.
struct ModelOffset {
  double value_Nm{}, half_width_Nm{};
  double friction_Nm{};
  bool is_known{};

  explicit ModelOffset(const OtherGravity& other) : friction_Nm(other.friction_Nm) {
    // A short sweep cannot distinguish an offset from gravity: subtracting its error would do harm.
    constexpr double widest_share = 0.02;
    if (!other.model_Nm || !other.offset_Nm) return;
    value_Nm = other.offset_Nm->value;
    half_width_Nm = std::hypot(other.offset_Nm->half_width(), other.offset_drift_Nm);
    is_known = friction_Nm > 0 && half_width_Nm <= widest_share * other.model_Nm->value;
  }

  /// @param friction_of_reading_Nm mean friction in the reading, there and back.
  [[nodiscard]] OffsetTaken at(double friction_of_reading_Nm) const {
    if (!is_known) return {};
    constexpr double largest_ratio = 3;
    const double ratio = std::clamp(friction_of_reading_Nm / friction_Nm, 0.0, largest_ratio);
    const double share = (1 + ratio) / 2;
    return {share * value_Nm, share, std::abs(value_Nm * (1 - ratio)) / 2};
  }
};

/// Mass of a torque read at an angle, with the angle's own uncertainty carried into the cosine.
/// @param offset subtracted from it; @param offset_half_width of the model's.
SurrogateMass make_mass(Estimator estimator, statistics::Estimate torque, double q_rad,
                        double cosine, const Context& c, const OffsetTaken& offset = {},
                        double offset_half_width = 0) {
  SurrogateMass m;
  m.estimator = estimator;
  m.torque_Nm = torque;
  m.q_rad = q_rad;
  const double from_peak = c.q_peak_rad ? q_rad - *c.q_peak_rad : 0.0;
  // The trough, half a turn on, is as good as the peak.
  const double away = std::remainder(from_peak, std::numbers::pi);
  const double reach = std::abs(away) + c.q_peak_half_width;
  // 1/cos grows with the distance from the peak: the angle's error can only widen the interval.
  const double by_angle =
      torque.value * std::abs(1 / std::cos(std::min(reach, 1.5)) - 1 / std::cos(away));
  const double by_offset = offset.share * offset_half_width / cosine;
  // The truth lies at one end of what is ambiguous as a rule, not in its middle.
  const double half_width =
      std::hypot(torque.half_width() / std::abs(cosine), by_angle, by_offset) +
      offset.ambiguity_Nm / std::abs(cosine);
  m.mean_cosine = cosine;
  m.offset = offset;
  m.gravity_Nm = statistics::symmetric_estimate(
      (torque.value - offset.value_Nm) / cosine, half_width,
      offset.share > 0 ? Statement{"interval.less_offset", {{"interval", torque.method}}}
                       : torque.method);
  m.mass_kg = statistics::scaled(
      m.gravity_Nm, joint::surrogate_mass_kg(1.0, c.gear_ratio, c.distance_m, c.gravity_m_s2, 1.0));
  return m;
}

const LoopPoint* find_point(const std::vector<LoopPoint>& points, Estimator name) {
  const auto it = std::find_if(points.begin(), points.end(),
                               [name](const LoopPoint& p) { return p.name == name; });
  return it == points.end() ? nullptr : &*it;
}

double cosine_at(const Context& c, double q_rad) {
  return c.q_peak_rad ? std::cos(q_rad - *c.q_peak_rad) : 1.0;
}

/// Whose gravity amplitude gives the mass where there is no loop.
Code mass_without_loop(const gravity::CogSweepResult& rough, const SurrogateMassesResult& out) {
  if (out.find(Estimator::model) != nullptr) return {"masses.of_model_only"};
  if (rough.found) return {"masses.of_sweep_only"};
  return {"masses.of_stated_gravity_only"};
}

/// The paper's six, the pair means, the mid-line and the loop fit.
void add_loop_masses(const gravity::CogSweepResult& rough, const HysteresisResult& hysteresis,
                     const OtherGravity& other, const Context& context,
                     SurrogateMassesResult& out) {
  const gravity::Ripple& ripple = rough.ripple;  // points and pairs are read at one position
  const ModelOffset offset(other);
  // At the trough the amplitude stands in the torque with a minus.
  const double side = cosine_at(context, hysteresis.midline_q_rad) < 0 ? -1.0 : 1.0;
  const OffsetTaken of_loop = offset.at(hysteresis.midline_friction_Nm);
  for (const Estimator name : loop_points) {
    const LoopPoint* p = find_point(hysteresis.points, name);
    if (p == nullptr) continue;
    const statistics::Estimate torque{
        p->torque_Nm, p->torque_low_Nm, p->torque_high_Nm, {"interval.one_reading"}};
    out.masses.push_back(make_mass(name, gravity::with_ripple(torque, ripple), p->q_rad,
                                   cosine_at(context, p->q_rad), context));
  }
  for (const Estimator pair : pair_means) {
    const auto [first, second] = present(points_of_pair(pair));
    const LoopPoint* p = find_point(hysteresis.steady_points, first);
    const LoopPoint* q = find_point(hysteresis.steady_points, second);
    if (p == nullptr || q == nullptr) continue;
    const double half_width =
        std::hypot(p->torque_high_Nm - p->torque_low_Nm, q->torque_high_Nm - q->torque_low_Nm) / 4;
    const double angle = (p->q_rad + q->q_rad) / 2;
    const double cosine = (cosine_at(context, p->q_rad) + cosine_at(context, q->q_rad)) / 2;
    const statistics::Estimate torque = statistics::symmetric_estimate(
        (p->torque_Nm + q->torque_Nm) / 2, half_width, {"interval.scatter_of_cycles"});
    const OffsetTaken of_pair = offset.at(std::abs(p->torque_Nm - q->torque_Nm) / 2);
    out.masses.push_back(make_mass(pair, gravity::with_ripple(torque, ripple), angle, cosine,
                                   context, of_pair, offset.half_width_Nm));
  }
  if (hysteresis.midline_Nm) {
    const statistics::Estimate torque = hysteresis.positions_hold_ripple
                                            ? *hysteresis.midline_Nm
                                            : gravity::with_ripple(*hysteresis.midline_Nm, ripple);
    out.masses.push_back(make_mass(Estimator::midline, torque, hysteresis.midline_q_rad,
                                   hysteresis.midline_mean_cos, context, of_loop,
                                   offset.half_width_Nm));
  }
  if (other.loop_fit_Nm) {
    // Already at the peak, and widened by ripple where that is due.
    out.masses.push_back(make_mass(Estimator::fit, statistics::scaled(*other.loop_fit_Nm, side),
                                   hysteresis.midline_q_rad, side, context, of_loop,
                                   offset.half_width_Nm));
  }
}

}  // namespace

const SurrogateMass* SurrogateMassesResult::find(std::optional<Estimator> estimator) const {
  const auto it = std::find_if(masses.begin(), masses.end(),
                               [&](const SurrogateMass& m) { return m.estimator == estimator; });
  return it == masses.end() ? nullptr : &*it;
}

SurrogateMassesResult identify_surrogate_masses(
    const gravity::CogSweepResult& rough, const HysteresisResult& hysteresis,
    const std::optional<statistics::Estimate>& q_peak_rad, double gear_ratio, double distance_m,
    double gravity_m_s2, const OtherGravity& other) {
  SurrogateMassesResult out;
  out.distance_m = distance_m;
  out.gravity_m_s2 = gravity_m_s2;
  Context context{{}, 0, gear_ratio, distance_m, gravity_m_s2};
  if (q_peak_rad) {
    context.q_peak_rad = q_peak_rad->value;
    context.q_peak_half_width = q_peak_rad->half_width();
  }
  const double loop_cosine = cosine_at(context, hysteresis.midline_q_rad);
  const bool is_near_peak = !hysteresis.found || std::abs(loop_cosine) >= least_loop_cosine;
  if (is_near_peak) add_loop_masses(rough, hysteresis, other, context, out);
  Context at_peak = context;
  at_peak.q_peak_half_width = 0;  // the amplitude's interval already holds it
  if (rough.found) {
    out.masses.push_back(make_mass(Estimator::sweep, rough.gravity_Nm,
                                   context.q_peak_rad.value_or(rough.q_peak_rad.value), 1.0,
                                   at_peak));
  }
  if (other.model_Nm && context.q_peak_rad) {
    out.masses.push_back(
        make_mass(Estimator::model, *other.model_Nm, *context.q_peak_rad, 1.0, at_peak));
  }
  if (other.stated) {
    at_peak.q_peak_rad = other.stated->q_peak_rad();
    const double torque = other.stated->amplitude_Nm() / gear_ratio;
    out.masses.push_back(make_mass(Estimator::stated,
                                   {torque, torque, torque, {"interval.stated_in_manifest"}},
                                   other.stated->q_peak_rad(), 1.0, at_peak));
  }

  out.stage.name = "surrogate_masses";
  if (out.masses.empty()) {
    out.stage.state = statistics::StageState::skipped;
    out.stage.reason = {"masses.no_gravity_torque"};
  } else if (!is_near_peak) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {
        "masses.loop_far_from_peak",
        {{"distance_deg", joint::degrees_per_rad * std::acos(std::abs(loop_cosine))},
         {"share_percent", 100 * std::abs(loop_cosine)}}};
  } else if (!hysteresis.found) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = mass_without_loop(rough, out);
  } else if (hysteresis.points.empty()) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {"masses.no_loop_points"};
  } else {
    out.stage.state = statistics::StageState::done;
  }
  return out;
}

}  // namespace tribolog::method::hysteresis
