#include "calibration/quantity_verdict.h"

#include <algorithm>

namespace tribolog::calibration {

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

std::string to_string(LimitState state) {
  switch (state) {
    case LimitState::inside:
      return "inside";
    case LimitState::outside:
      return "outside";
    case LimitState::crosses:
      return "crosses";
    case LimitState::unknown:
      break;
  }
  return "unknown";
}

std::string to_string(LimitRule rule) {
  switch (rule) {
    case LimitRule::min:
      return "min";
    case LimitRule::max:
      return "max";
    case LimitRule::half_width:
      return "half_width";
    case LimitRule::half_width_percent:
      break;
  }
  return "half_width_percent";
}

void lower(QuantityVerdict& quantity, Verdict to, const Statement& reason,
           const Statement& experiment) {
  auto& reasons = quantity.reasons;
  const bool is_worse = to > quantity.verdict;
  if (is_worse) quantity.verdict = to;
  if (std::find(reasons.begin(), reasons.end(), reason) != reasons.end()) return;
  reasons.insert(is_worse ? reasons.begin() : reasons.end(), reason);
  if (is_worse || quantity.experiment.empty()) quantity.experiment = experiment;
}

std::string to_string(RuleState state) {
  switch (state) {
    case RuleState::kept:
      return "kept";
    case RuleState::broken:
      return "broken";
    case RuleState::not_computed:
      break;
  }
  return "not_computed";
}

}  // namespace tribolog::calibration
