#include "verdict/curve_findings.h"

#include "calibration/headline.h"

namespace tribolog::verdict {

std::vector<Statement> curve_findings(const calibration::Calibration& c) {
  std::vector<Statement> findings;
  const method::model::ModelLaw& law = c.model.law;
  if (!law.empty() && !law.has_dip()) {
    findings.push_back(calibration::curve_headline(c).stribeck_speed_rad_s.why_not);
  }
  if (law.bends()) findings.push_back({"model.law_bends"});
  const method::viscous::DirectionAngles& angles = c.viscous.angles;
  const bool from_runs = !c.viscous.runs.empty() && !c.viscous.from_sweep;
  if (from_runs && angles.has_rising && angles.has_falling && !angles.share_angles()) {
    findings.push_back({"verdict.runs_share_no_angle", {{"angles", angles.described()}}});
  }
  return findings;
}

}  // namespace tribolog::verdict
