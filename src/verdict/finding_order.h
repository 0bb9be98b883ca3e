#pragma once
// Which finding explains which, and the order in which they are listed.

#include <cstddef>
#include <vector>

#include "base/statement.h"
#include "calibration/quantity_verdict.h"

namespace tribolog::calibration {
struct Calibration;
}

namespace tribolog::verdict {

/// What a rule found becomes a reason of the numbers that rest on what follows from it: an
/// offset is a reason wherever estimates disagree as it makes them.
void give_causes_as_reasons(const std::vector<calibration::RuleOutcome>& rules,
                            std::vector<calibration::QuantityVerdict>& quantities);

/// Behind the failing checks: that on which most numbers rest their doubt first, and what explains
/// another finding before it.
/// @param checks failing ones, at the head of the findings.
void order_findings(const std::vector<calibration::QuantityVerdict>& quantities, std::size_t checks,
                    std::vector<Statement>& findings);

}  // namespace tribolog::verdict
