#include "verdict/curve_findings.h"

#include <fmt/format.h>

namespace tribolog::verdict {

std::vector<std::string> curve_findings(const calibration::Calibration& c) {
  std::vector<std::string> findings;
  if (c.load_dependence.found) findings.push_back(c.load_dependence.sentence);
  if (c.direction_asymmetry.found) findings.push_back(c.direction_asymmetry.sentence);
  const method::viscous::DirectionAngles& angles = c.viscous.angles;
  const bool from_runs = !c.viscous.runs.empty() && !c.viscous.from_sweep;
  if (from_runs && angles.has_rising && angles.has_falling && !angles.share_angles()) {
    findings.push_back(
        angles.in_words() +
        ", so that gravity and friction cannot be told apart by comparing them; record every speed "
        "in both directions over the same angles");
  }
  if (c.run_gravity.found && c.run_gravity.always_lifts && !c.rough.found) {
    findings.push_back(
        "in the runs at constant speed the drive lifts the load all the way: friction that grows "
        "with the load would be taken for gravity; runs that also lower it would tell");
  }
  const method::viscous::CurveModelChoice& model = c.curve_model;
  if (model.chosen_any && !model.carries_five && c.friction.waiboer) {
    findings.push_back(model.five_sentence + "; use " + method::viscous::in_words(model.chosen) +
                       " (stage 8) instead");
  }
  return findings;
}

}  // namespace tribolog::verdict
