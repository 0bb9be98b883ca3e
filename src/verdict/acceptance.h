#pragma once
// The manifest's acceptance limits compared with estimates and intervals.

#include <vector>

#include "calibration/quantity_verdict.h"
#include "joint/dataset.h"

namespace tribolog::verdict {

/// Adds the outcome of each limit to the quantity it is for. A limit that is not shown to be kept
/// makes a usable quantity doubtful, and the quantity then counts in the overall verdict.
/// @param gear_ratio n; converts the estimates to the side that the limit names.
void apply_limits(const std::vector<joint::AcceptanceLimit>& limits, double gear_ratio,
                  std::vector<calibration::QuantityVerdict>& quantities);

}  // namespace tribolog::verdict
