#include "verdict/curve_findings.h"

namespace tribolog::verdict {

std::vector<Statement> curve_findings(const calibration::Calibration& c) {
  std::vector<Statement> findings = c.curve_model.sliding.findings;
  const method::viscous::DirectionAngles& angles = c.viscous.angles;
  const bool from_runs = !c.viscous.runs.empty() && !c.viscous.from_sweep;
  if (from_runs && angles.has_rising && angles.has_falling && !angles.share_angles()) {
    findings.push_back({"verdict.runs_share_no_angle", {{"angles", angles.described()}}});
  }
  return findings;
}

Statement which_model(const calibration::Calibration& c) {
  const method::viscous::CurveModelChoice& model = c.curve_model;
  if (!model.chosen_any || model.carries_five || !c.friction.waiboer) return {};
  return {"verdict.use_chosen_model",
          {{"why", model.five_sentence}, {"model", method::viscous::described(model.chosen)}}};
}

}  // namespace tribolog::verdict
