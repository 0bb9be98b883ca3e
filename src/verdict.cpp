#include "verdict.h"

#include <cmath>

#include <fmt/format.h>

#include "curve_findings.h"

namespace tribolog {
namespace {

/// Disagreement of two estimates in units of their joint 95 % interval; above 1 it is a finding.
double disagreement(const Estimate& a, const Estimate& b) {
  const double joint = std::hypot(a.half_width(), b.half_width());
  return joint > 0 ? std::abs(a.value - b.value) / joint : 0.0;
}

void compare_masses(const Calibration& c, std::vector<std::string>& findings) {
  const SurrogateMass* midline = c.masses.find("midline");
  const SurrogateMass* sweep = c.masses.find("sweep");
  if (midline == nullptr || sweep == nullptr) return;
  const double difference = midline->mass_kg.value - sweep->mass_kg.value;
  // A tenth of a percent is of no consequence, however narrow the intervals.
  if (disagreement(midline->mass_kg, sweep->mass_kg) > 1 &&
      std::abs(difference) > 1e-3 * sweep->mass_kg.value) {
    findings.push_back(
        fmt::format("mid-line and sweep disagree: {:.3f} kg against {:.3f} kg, more than their "
                    "intervals allow; "
                    "torque ripple or friction that depends on the load would do that",
                    midline->mass_kg.value, sweep->mass_kg.value));
  }
}

}  // namespace

Judgement judge(const Calibration& c) {
  Judgement out;
  const bool has_angle = c.q_peak_rad.has_value();
  const bool has_mass = !c.selection.recommended.empty();
  for (const StageReport& stage : c.stages()) {
    if (stage.state != StageState::done && !stage.reason.empty()) {
      out.findings.push_back(stage.reason);
    }
  }
  for (std::string& finding : curve_findings(c)) out.findings.push_back(std::move(finding));
  std::vector<std::string> disagreements;
  compare_masses(c, disagreements);
  out.findings.insert(out.findings.begin(), disagreements.begin(), disagreements.end());

  if (!has_angle || !has_mass) {
    out.verdict = Verdict::not_identifiable;
    out.sentence = !has_angle && !has_mass
                       ? "Neither the centre of gravity nor the surrogate mass can be found in "
                         "these recordings."
                   : has_angle ? "The surrogate mass cannot be found in these recordings."
                               : "The angle of the centre of gravity cannot be found in these "
                                 "recordings.";
    return out;
  }
  const bool complete = c.rough.stage.state == StageState::done &&
                        c.hysteresis.stage.state == StageState::done &&
                        c.viscous.stage.state == StageState::done && !c.quality.errors.empty();
  if (complete && disagreements.empty()) {
    out.verdict = Verdict::usable;
    out.sentence = "All stages have their data, and the independent estimates of the mass agree.";
  } else {
    out.verdict = Verdict::doubtful;
    out.sentence = disagreements.empty()
                       ? "Angle and mass are known, but not every stage had the data it needs."
                       : "Angle and mass are known, but independent estimates disagree.";
  }
  return out;
}

}  // namespace tribolog
