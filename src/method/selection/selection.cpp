#include "method/selection/selection.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

}  // namespace

SelectionResult select_estimator(const hysteresis::SurrogateMassesResult& masses,
                                 const QualityErrorsResult& errors,
                                 const hysteresis::HysteresisResult& hysteresis,
                                 const std::optional<statistics::Estimate>& q_peak_rad) {
  SelectionResult out;
  out.stage = {"selection", statistics::StageState::done, ""};
  if (q_peak_rad) out.q_c_rad = statistics::scaled(*q_peak_rad, -1.0);

  double smallest = INFINITY;
  for (const char name : hysteresis::loop_point_names) {
    const QualityError* error = errors.find(std::string(1, name));
    if (error == nullptr || !(error->rms_percent < smallest)) continue;
    smallest = error->rms_percent;
    out.paper_rule = name;
  }
  if (masses.find("midline") != nullptr) {
    out.recommended = "midline";
    out.why =
        "The mid-line averages the whole steady loop, in which friction cancels whatever its "
        "model; a single point keeps the friction of its instant.";
  } else if (masses.find("sweep") != nullptr) {
    out.recommended = "sweep";
    out.why =
        "No hysteresis loop at the gravity peak was recorded; the gravity amplitude of the rough "
        "sweep is the only "
        "estimate of the mass.";
  } else if (masses.find("runs") != nullptr) {
    out.recommended = "runs";
    out.why =
        "Neither a hysteresis loop at the gravity peak nor a sweep was recorded; the gravity "
        "amplitude of the runs at constant speed is the only estimate of the mass.";
  } else if (masses.find(hysteresis::stated_estimator) != nullptr) {
    out.recommended = hysteresis::stated_estimator;
    out.why =
        "No recording shows the gravity torque; the mass is the one that the manifest states.";
  }
  if (out.recommended.empty()) {
    out.stage.state = statistics::StageState::skipped;
    out.stage.reason = "there is no candidate to choose from";
    return out;
  }
  if (out.paper_rule.empty()) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason =
        errors.errors.empty()
            ? "the paper's rule cannot be applied: there is no quality error to compare"
            : "the paper's rule cannot be applied: the points A to F were not found";
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
    out.why += fmt::format(
        " Against the reference its curve is off by {:.2g} % of the driving torque (rms), that of "
        "point {} by {:.2g} %.",
        ours->rms_percent, out.paper_rule, smallest);
  }
  if (!out.paper_rule_rivals.empty()) {
    out.why += fmt::format(
        " Within the intervals of single readings the paper's rule could have chosen {} instead of "
        "{}: its choice is left to noise here.",
        fmt::join(out.paper_rule_rivals, " or "), out.paper_rule);
  }
  return out;
}

}  // namespace tribolog::method::selection
