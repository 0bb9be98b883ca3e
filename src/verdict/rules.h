#pragma once
// The verdict's rules: each compares one number found in the data with a threshold, and states
// which quantities are lowered, and how far, where it is larger. All are in one table (rules.cpp);
// the report and the JSON show it with the values found. The worst applies.
//
// What the stages state of their own results (quantity_rooms.h) and the checks on the data apply as
// well: those are no thresholds.

#include <optional>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/quantity_verdict.h"

namespace tribolog::verdict {

/// What a rule found: the number, and the statement for when it is too large.
struct Measured {
  double value{};
  Statement finding;
};

struct Rule {
  const char* name;                ///< Stable: "loop_misfit".
  const char* unit;                ///< Of value and threshold; "" if none.
  double threshold;                ///< A larger value breaks the rule.
  calibration::Verdict lowers_to;  ///< usable: the finding is reported, and was corrected.
  std::vector<joint::Quantity> quantities;
  Code experiment;  ///< What to record next.
  /// nullopt: the data do not show it.
  std::optional<Measured> (*measure)(const calibration::Calibration& calibration);
  /// No news where it is as usual: told after all other findings.
  bool is_note{};
};

/// In the order in which their findings are reported, most important first.
const std::vector<Rule>& rules();

/// Applies all rules. @param quantities are lowered where a rule is broken, with its finding as the
/// reason.
std::vector<calibration::RuleOutcome> apply_rules(
    const calibration::Calibration& calibration,
    std::vector<calibration::QuantityVerdict>& quantities);

}  // namespace tribolog::verdict
