#include "stages/surrogate_masses.h"

#include <algorithm>
#include <cmath>

#include "joint/gravity_load.h"
#include "stages/gravity_at_positions.h"

namespace tribolog {
namespace {

struct Context {
  std::optional<double> q_peak_rad;
  double q_peak_half_width{};
  double gear_ratio{};
  double distance_m{};
  double gravity_m_s2{};
};

/// Mass of a torque read at an angle, with the angle's own uncertainty carried into the cosine.
SurrogateMass make_mass(std::string estimator, Estimate torque, double q_rad, double cosine,
                        const Context& c) {
  SurrogateMass m;
  m.estimator = std::move(estimator);
  m.torque_Nm = torque;
  m.q_rad = q_rad;
  const double from_peak = c.q_peak_rad ? q_rad - *c.q_peak_rad : 0.0;
  const double reach = std::abs(from_peak) + c.q_peak_half_width;
  // 1/cos grows with the distance from the peak: the angle's error can only widen the interval.
  const double by_angle =
      torque.value * std::abs(1 / std::cos(std::min(reach, 1.5)) - 1 / std::cos(from_peak));
  const double half_width = std::hypot(torque.half_width() / cosine, by_angle);
  m.gravity_Nm = symmetric_estimate(torque.value / cosine, half_width, torque.method);
  m.mass_kg =
      scaled(m.gravity_Nm, surrogate_mass_kg(1.0, c.gear_ratio, c.distance_m, c.gravity_m_s2, 1.0));
  return m;
}

const LoopPoint* find_point(const std::vector<LoopPoint>& points, char name) {
  const auto it = std::find_if(points.begin(), points.end(),
                               [name](const LoopPoint& p) { return p.name == name; });
  return it == points.end() ? nullptr : &*it;
}

}  // namespace

const SurrogateMass* SurrogateMassesResult::find(const std::string& estimator) const {
  const auto it = std::find_if(masses.begin(), masses.end(),
                               [&](const SurrogateMass& m) { return m.estimator == estimator; });
  return it == masses.end() ? nullptr : &*it;
}

SurrogateMassesResult identify_surrogate_masses(const CogSweepResult& rough,
                                                const HysteresisResult& hysteresis,
                                                const std::optional<Estimate>& q_peak_rad,
                                                double gear_ratio, double distance_m,
                                                double gravity_m_s2) {
  SurrogateMassesResult out;
  out.distance_m = distance_m;
  out.gravity_m_s2 = gravity_m_s2;
  Context context{{}, 0, gear_ratio, distance_m, gravity_m_s2};
  if (q_peak_rad) {
    context.q_peak_rad = q_peak_rad->value;
    context.q_peak_half_width = q_peak_rad->half_width();
  }
  const auto cosine_at = [&](double q) {
    return context.q_peak_rad ? std::cos(q - *context.q_peak_rad) : 1.0;
  };

  std::vector<double> centres;
  for (const Oscillation& o : hysteresis.oscillations) centres.push_back(o.centre_rad);
  // The points are of the first position. The mid-line is of all, and its scatter has the ripple
  // where they are enough.
  const bool enough = distinct_positions(centres, gear_ratio) >= fewest_positions;
  const double ripple = rough.ripple_Nm;
  const double midline_ripple = enough ? 0.0 : ripple;
  for (const char name : loop_point_names) {
    const LoopPoint* p = find_point(hysteresis.points, name);
    if (p == nullptr) continue;
    const Estimate torque{p->torque_Nm, p->torque_low_Nm, p->torque_high_Nm, "one reading"};
    out.masses.push_back(make_mass(std::string(1, name), with_ripple(torque, ripple), p->q_rad,
                                   cosine_at(p->q_rad), context));
  }
  for (const auto& [first, second] : {std::pair{'A', 'B'}, {'C', 'D'}, {'E', 'F'}}) {
    const LoopPoint* p = find_point(hysteresis.steady_points, first);
    const LoopPoint* q = find_point(hysteresis.steady_points, second);
    if (p == nullptr || q == nullptr) continue;
    const double half_width =
        std::hypot(p->torque_high_Nm - p->torque_low_Nm, q->torque_high_Nm - q->torque_low_Nm) / 4;
    const double angle = (p->q_rad + q->q_rad) / 2;
    const double cosine = (cosine_at(p->q_rad) + cosine_at(q->q_rad)) / 2;
    const Estimate torque =
        symmetric_estimate((p->torque_Nm + q->torque_Nm) / 2, half_width, "scatter of the cycles");
    out.masses.push_back(
        make_mass({first, second}, with_ripple(torque, ripple), angle, cosine, context));
  }
  if (hysteresis.midline_Nm) {
    out.masses.push_back(make_mass("midline", with_ripple(*hysteresis.midline_Nm, midline_ripple),
                                   hysteresis.midline_q_rad, hysteresis.midline_mean_cos, context));
  }
  if (hysteresis.lugre && hysteresis.lugre->gravity_Nm) {
    // Already at the peak, and widened by ripple where that is due.
    out.masses.push_back(
        make_mass("fit", *hysteresis.lugre->gravity_Nm, hysteresis.midline_q_rad, 1.0, context));
  }
  if (rough.found) {
    Context at_peak = context;
    at_peak.q_peak_half_width = 0;  // the amplitude's interval already holds it
    out.masses.push_back(make_mass("sweep", rough.gravity_Nm,
                                   context.q_peak_rad.value_or(rough.q_peak_rad.value), 1.0,
                                   at_peak));
  }

  out.stage.name = "surrogate_masses";
  if (out.masses.empty()) {
    out.stage.state = StageState::skipped;
    out.stage.reason =
        "neither an oscillation nor a sweep gives a gravity torque, so there is no surrogate mass";
  } else if (!hysteresis.found) {
    out.stage.state = StageState::partial;
    out.stage.reason =
        "without a hysteresis loop the paper's six masses and the mid-line are not to be had; the "
        "mass is that of the sweep's gravity amplitude";
  } else if (hysteresis.points.empty()) {
    out.stage.state = StageState::partial;
    out.stage.reason =
        "the points A to F were not found: no whole turn of the loop with its "
        "bristle deflection";
  } else {
    out.stage.state = StageState::done;
  }
  return out;
}

}  // namespace tribolog
