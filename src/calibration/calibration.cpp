#include "calibration/calibration.h"

#include <algorithm>

namespace tribolog::calibration {

const ReturnedQuantity* TruthCheckResult::find(const std::string& name) const {
  const auto it = std::find_if(quantities.begin(), quantities.end(),
                               [&](const ReturnedQuantity& q) { return q.name == name; });
  return it == quantities.end() ? nullptr : &*it;
}

std::vector<statistics::StageReport> Calibration::stages() const {
  std::vector<statistics::StageReport> all{rough.stage,     precise.stage, hysteresis.stage,
                                           masses.stage,    viscous.stage, quality.stage,
                                           selection.stage, friction.stage};
  if (!break_away.ramps.empty()) all.push_back(break_away.stage);
  return all;
}

}  // namespace tribolog::calibration
