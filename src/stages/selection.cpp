#include "stages/selection.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace tribolog {

SelectionResult select_estimator(const SurrogateMassesResult& masses,
                                 const QualityErrorsResult& errors,
                                 const HysteresisResult& hysteresis,
                                 const std::optional<Estimate>& q_peak_rad) {
  SelectionResult out;
  out.stage = {"selection", StageState::done, ""};
  if (q_peak_rad) out.q_c_rad = scaled(*q_peak_rad, -1.0);

  double smallest = INFINITY;
  for (const char name : loop_point_names) {
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
        "No hysteresis loop was recorded; the gravity amplitude of the rough sweep is the only "
        "estimate of the mass.";
  }
  if (out.recommended.empty()) {
    out.stage.state = StageState::skipped;
    out.stage.reason = "there is no candidate to choose from";
    return out;
  }
  if (out.paper_rule.empty()) {
    out.stage.state = StageState::partial;
    out.stage.reason =
        errors.errors.empty()
            ? "the paper's rule cannot be applied: there is no quality error to compare"
            : "the paper's rule cannot be applied: the points A to F were not found";
    return out;
  }
  if (q_peak_rad) {
    const auto chosen =
        std::find_if(hysteresis.points.begin(), hysteresis.points.end(),
                     [&](const LoopPoint& p) { return out.paper_rule[0] == p.name; });
    if (chosen != hysteresis.points.end()) {
      out.q_c_corrected_rad = -q_peak_rad->value - (chosen->q_rad - q_peak_rad->value);
    }
  }
  const QualityError* ours = errors.find(out.recommended);
  if (ours != nullptr) {
    out.why += fmt::format(
        " Against the reference its curve is off by {:.2g} % of the driving torque (rms), that of "
        "point {} by {:.2g} %.",
        ours->rms_percent, out.paper_rule, smallest);
  }
  return out;
}

}  // namespace tribolog
