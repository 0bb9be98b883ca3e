#pragma once
// Puts the stated interval into the results where that is the resampled one.

#include "method/intervals/bootstrap.h"

namespace tribolog {

/// Values stay; intervals and the words of how they were made change. Without resamples nothing
/// does.
void state_intervals(const IntervalsResult& intervals, FrictionParametersResult& friction);

}  // namespace tribolog
