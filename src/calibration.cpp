#include "calibration.h"

namespace tribolog {

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::usable:
      return "usable";
    case Verdict::doubtful:
      return "doubtful";
    case Verdict::not_identifiable:
      return "not_identifiable";
  }
  return "unknown";
}

std::vector<StageReport> Calibration::stages() const {
  std::vector<StageReport> all{rough.stage,   precise.stage, hysteresis.stage, masses.stage,
                               viscous.stage, quality.stage, selection.stage,  friction.stage};
  if (!break_away.ramps.empty()) all.push_back(break_away.stage);
  return all;
}

}  // namespace tribolog
