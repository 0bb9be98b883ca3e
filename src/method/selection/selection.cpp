#include "method/selection/selection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace tribolog::method::selection {
namespace {

std::vector<std::string> rivals_of(const std::string& chosen, const std::string& recommended,
                                   const hysteresis::SurrogateMassesResult& masses) {
  const hysteresis::SurrogateMass* centre = masses.find(recommended);
  const hysteresis::SurrogateMass* nearest = masses.find(chosen);
  if (centre == nullptr || nearest == nullptr) return {};
  const auto distance = [&](const hysteresis::SurrogateMass& mass, double side) {
    const double half = (mass.mass_kg.high - mass.mass_kg.low) / 2;
    return std::abs(mass.mass_kg.value - centre->mass_kg.value) + side * half;
  };
  std::vector<std::string> rivals;
  for (const char name : hysteresis::loop_point_names) {
    const std::string other(1, name);
    const hysteresis::SurrogateMass* mass = masses.find(other);
    if (mass == nullptr || other == chosen) continue;
    if (distance(*mass, -1) < distance(*nearest, +1)) rivals.push_back(other);
  }
  return rivals;
}

struct Recommendation {
  std::string estimator;  ///< Empty: there is no candidate.
  Statement why;
};

Recommendation recommend(const hysteresis::SurrogateMassesResult& masses) {
  if (masses.find("midline") != nullptr) return {"midline", {"selection.midline"}};
  if (masses.find("sweep") != nullptr) return {"sweep", {"selection.sweep_alone"}};
  if (masses.find("runs") != nullptr) return {"runs", {"selection.runs_alone"}};
  if (masses.find(hysteresis::stated_estimator) != nullptr) {
    return {hysteresis::stated_estimator, {"selection.stated_alone"}};
  }
  return {};
}

Statement in_sentences(const std::vector<Statement>& sentences) {
  return {"selection.why", {{"sentences", sentences}}};
}

Statement left_to_noise(const std::string& chosen, const std::vector<std::string>& rivals) {
  std::vector<Statement> points;
  points.reserve(rivals.size());
  for (const std::string& rival : rivals) points.emplace_back(Code::of("estimator." + rival));
  return {"selection.left_to_noise", {{"rivals", points}, {"point", chosen}}};
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
  for (const char name : hysteresis::loop_point_names) {
    const QualityError* error = errors.find(std::string(1, name));
    if (error == nullptr || !(error->rms_percent < smallest)) continue;
    smallest = error->rms_percent;
    out.paper_rule = name;
  }
  const Recommendation recommendation = recommend(masses);
  out.recommended = recommendation.estimator;
  if (out.recommended.empty()) {
    out.stage.state = statistics::StageState::skipped;
    out.stage.reason = {"selection.no_candidate"};
    return out;
  }
  std::vector<Statement> why{recommendation.why};
  out.why = in_sentences(why);
  if (out.paper_rule.empty()) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = errors.errors.empty() ? Code{"selection.no_quality_error"}
                                             : Code{"selection.no_loop_points"};
    return out;
  }
  if (q_peak_rad) {
    const auto chosen =
        std::find_if(hysteresis.points.begin(), hysteresis.points.end(),
                     [&](const hysteresis::LoopPoint& p) { return out.paper_rule[0] == p.name; });
    if (chosen != hysteresis.points.end()) {
      out.q_c_corrected_rad = -q_peak_rad->value - (chosen->q_rad - q_peak_rad->value);
    }
  }
  out.paper_rule_rivals = rivals_of(out.paper_rule, out.recommended, masses);
  const QualityError* ours = errors.find(out.recommended);
  if (ours != nullptr) {
    why.push_back({"selection.quality_errors",
                   {{"rms_percent", ours->rms_percent},
                    {"point", out.paper_rule},
                    {"point_rms_percent", smallest}}});
  }
  if (!out.paper_rule_rivals.empty()) {
    why.push_back(left_to_noise(out.paper_rule, out.paper_rule_rivals));
  }
  out.why = in_sentences(why);
  return out;
}

}  // namespace tribolog::method::selection
