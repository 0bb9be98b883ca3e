#include "verdict.h"

#include "curve_findings.h"

namespace tribolog {

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
  if (c.position_plan) {
    out.findings.insert(out.findings.begin(), ripple_in_words(*c.position_plan, c.rough.ripple));
  }
  const std::vector<std::string>& disagreements = c.cross_checks.findings;
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
  if (complete && !c.cross_checks.doubtful) {
    out.verdict = Verdict::usable;
    out.sentence = "All stages have their data, and the independent estimates of the mass agree.";
  } else {
    out.verdict = Verdict::doubtful;
    out.sentence = !c.cross_checks.doubtful
                       ? "Angle and mass are known, but not every stage had the data it needs."
                       : "Angle and mass are known, but independent estimates disagree.";
  }
  return out;
}

}  // namespace tribolog
