#include "calibration/quantity_verdict.h"

#include <algorithm>

#include "base/enum_text.h"

namespace tribolog::calibration {

std::string to_string(Verdict verdict) { return own_name(verdict); }

std::string to_string(LimitState state) { return own_name(state); }

std::string to_string(LimitRule rule) { return own_name(rule); }

void lower(QuantityVerdict& quantity, Verdict to, const Statement& reason,
           const Statement& experiment) {
  auto& reasons = quantity.reasons;
  const bool is_worse = to > quantity.verdict;
  if (is_worse) quantity.verdict = to;
  if (std::find(reasons.begin(), reasons.end(), reason) != reasons.end()) return;
  reasons.insert(is_worse ? reasons.begin() : reasons.end(), reason);
  if (is_worse || quantity.experiment.empty()) quantity.experiment = experiment;
}

std::string to_string(RuleState state) { return own_name(state); }

}  // namespace tribolog::calibration
