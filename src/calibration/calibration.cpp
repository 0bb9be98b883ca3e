#include "calibration/calibration.h"

#include <algorithm>

namespace tribolog::calibration {

const ReturnedQuantity* TruthCheckResult::find(ReadingName name) const {
  const auto it = std::find_if(quantities.begin(), quantities.end(),
                               [&](const ReturnedQuantity& q) { return q.name == name; });
  return it == quantities.end() ? nullptr : &*it;
}

const QuantityVerdict* Judgement::find(joint::Quantity quantity) const {
  const auto it = std::find_if(quantities.begin(), quantities.end(),
                               [&](const QuantityVerdict& q) { return q.quantity == quantity; });
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
