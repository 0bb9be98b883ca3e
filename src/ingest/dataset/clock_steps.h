#pragma once
// The steps of a clock as it was logged.

#include <vector>

namespace tribolog {

/// Median of the rising steps, in the unit of the times; 0 where none rises. Gaps (NaN) and steps
/// back or of no length say nothing.
double median_clock_step(const std::vector<double>& times);

}  // namespace tribolog
