#include "method/selection/selection.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tribolog::method::selection {
namespace {

using hysteresis::Estimator;

std::vector<Estimator> within_noise_of(Estimator chosen, Estimator recommended,
                                       const hysteresis::SurrogateMassesResult& masses) {
  const hysteresis::SurrogateMass* centre = masses.find(recommended);
  const hysteresis::SurrogateMass* nearest = masses.find(chosen);
  if (centre == nullptr || nearest == nullptr) return {};
  const auto distance = [&](const hysteresis::SurrogateMass& mass, double side) {
    const double half = (mass.mass_kg.high - mass.mass_kg.low) / 2;
    return std::abs(mass.mass_kg.value - centre->mass_kg.value) + side * half;
  };
  std::vector<Estimator> others;
  for (const Estimator other : hysteresis::loop_points) {
    const hysteresis::SurrogateMass* mass = masses.find(other);
    if (mass == nullptr || other == chosen) continue;
    if (distance(*mass, -1) < distance(*nearest, +1)) others.push_back(other);
  }
  return others;
}

struct Recommendation {
  Estimator estimator;
  Code why;
};

/// The first that has a mass is chosen.
constexpr Recommendation in_order_of_trust[] = {{Estimator::model, "selection.model"},
                                                {Estimator::midline, "selection.midline"},
                                                {Estimator::sweep, "selection.sweep_alone"},
                                                {Estimator::stated, "selection.stated_alone"}};

std::optional<Recommendation> recommend(const hysteresis::SurrogateMassesResult& masses) {
  const hysteresis::SurrogateMass* stated = masses.find(Estimator::stated);
  if (stated != nullptr && stated->gravity_Nm.value == 0) {
    return Recommendation{Estimator::stated, "selection.no_gravity"};
  }
  for (const Recommendation& one : in_order_of_trust) {
    if (masses.find(one.estimator) != nullptr) return one;
  }
  return std::nullopt;
}

Statement in_sentences(const std::vector<Statement>& sentences) {
  return {"selection.why", {{"sentences", sentences}}};
}

Statement left_to_noise(Estimator chosen, const std::vector<Estimator>& others) {
  std::vector<Statement> points;
  points.reserve(others.size());
  for (const Estimator other : others) {
    points.emplace_back(Code::of("estimator." + to_string(other)));
  }
  return {"selection.left_to_noise", {{"rivals", points}, {"point", to_string(chosen)}}};
}

}  // namespace

SelectionResult select_estimator(const hysteresis::SurrogateMassesResult& masses,
                                 const QualityErrorsResult& errors,
                                 const hysteresis::HysteresisResult& hysteresis,
                                 const std::optional<statistics::Estimate>& q_peak_rad) {
  SelectionResult out;
  out.stage = {"selection", statistics::StageState::done, {}};
  if (q_peak_rad) out.q_c_rad = statistics::scaled(*q_peak_rad, -1.0);

  double smallest = INFINITY;
  for (const Estimator point : hysteresis::loop_points) {
    const QualityError* error = errors.find(point);
    if (error == nullptr || !(error->rms_percent < smallest)) continue;
    smallest = error->rms_percent;
    out.paper_rule = point;
  }
  const std::optional<Recommendation> recommendation = recommend(masses);
  if (!recommendation) {
    out.stage.state = statistics::StageState::skipped;
    out.stage.reason =
        masses.stage.reason.empty() ? Statement{"selection.no_candidate"} : masses.stage.reason;
    return out;
  }
  out.recommended = recommendation->estimator;
  std::vector<Statement> why{recommendation->why};
  out.why = in_sentences(why);
  if (!out.paper_rule) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = errors.errors.empty() ? Code{"selection.no_quality_error"}
                                             : Code{"selection.no_loop_points"};
    return out;
  }
  if (q_peak_rad) {
    const auto chosen =
        std::find_if(hysteresis.points.begin(), hysteresis.points.end(),
                     [&](const hysteresis::LoopPoint& p) { return p.name == out.paper_rule; });
    if (chosen != hysteresis.points.end()) {
      out.q_c_corrected_rad = -q_peak_rad->value - (chosen->q_rad - q_peak_rad->value);
    }
  }
  out.paper_rule_rivals = within_noise_of(*out.paper_rule, *out.recommended, masses);
  const QualityError* ours = errors.find(out.recommended);
  if (ours != nullptr) {
    why.push_back({"selection.quality_errors",
                   {{"rms_percent", ours->rms_percent},
                    {"point", to_string(*out.paper_rule)},
                    {"point_rms_percent", smallest}}});
  }
  if (!out.paper_rule_rivals.empty()) {
    why.push_back(left_to_noise(*out.paper_rule, out.paper_rule_rivals));
  }
  out.why = in_sentences(why);
  return out;
}

}  // namespace tribolog::method::selection
