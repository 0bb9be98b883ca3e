#pragma once
// What a quantity that does not come back from its own simulation means for the verdict on it.

#include <string>
#include <vector>

#include "calibration/quantity_verdict.h"
#include "calibration/truth_check_result.h"

namespace tribolog {

/// Makes the quantities doubtful that the method cannot find again.
/// @param recommended estimator of the mass: gravity torque and mass stand on it alone.
void apply_truth_check(const TruthCheckResult& check, const std::string& recommended,
                       std::vector<QuantityVerdict>& quantities);

}  // namespace tribolog
