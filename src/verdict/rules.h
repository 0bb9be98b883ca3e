#pragma once
// The verdict's rules: each holds one number, found in the data, against a threshold, and says what
// becomes of which quantities where it is larger. All of them stand in one table (rules.cpp); the
// report and the JSON show it with the values found. The worst applies.
//
// What the stages say of their own results (quantity_rooms.h) and the checks on the data come
// besides: those are no thresholds.

#include <optional>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/quantity_verdict.h"

namespace tribolog::verdict {

/// What a rule found: the number, and what to say where it is too large.
struct Measured {
  double value{};
  Statement finding;
};

struct Rule {
  const char* name;  ///< Stable: "torque_lag".
  const char* unit;  ///< Of value and threshold; "" without.
  double threshold;  ///< A larger value breaks the rule.
  calibration::Verdict lowers_to;  ///< usable: what was found is told, and was corrected.
  std::vector<joint::Quantity> quantities;
  Code experiment;  ///< What to record next.
  /// nullopt: the data do not show it.
  std::optional<Measured> (*measure)(const calibration::Calibration& calibration);
  /// Why the quantities are doubtful where the data do not show it; empty: they are not.
  Code unknown{};
};

/// In the order of weight in which their findings are told.
const std::vector<Rule>& rules();

/// Applies all of them. @param quantities are lowered with what a broken rule found as the reason.
std::vector<calibration::RuleOutcome> apply_rules(
    const calibration::Calibration& calibration,
    std::vector<calibration::QuantityVerdict>& quantities);

}  // namespace tribolog::verdict
