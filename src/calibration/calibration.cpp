#include "calibration/calibration.h"

namespace tribolog {

std::vector<StageReport> Calibration::stages() const {
  std::vector<StageReport> all{rough.stage,   precise.stage, hysteresis.stage, masses.stage,
                               viscous.stage, quality.stage, selection.stage,  friction.stage};
  if (!break_away.ramps.empty()) all.push_back(break_away.stage);
  return all;
}

}  // namespace tribolog
