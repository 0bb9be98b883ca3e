#pragma once
// The manifest's acceptance limits held against estimates and intervals.

#include <vector>

#include "calibration/quantity_verdict.h"
#include "joint/dataset.h"

namespace tribolog::verdict {

/// Adds the outcome of each limit to the quantity it speaks of. A limit that is not shown to be
/// kept makes a usable quantity doubtful, and the quantity then takes part in the verdict over all.
/// @param gear_ratio carries the estimates to the side that the limit names.
void apply_limits(const std::vector<joint::AcceptanceLimit>& limits, double gear_ratio,
                  std::vector<calibration::QuantityVerdict>& quantities);

}  // namespace tribolog::verdict
