#pragma once
// What a failing check on the data does to each quantity.

#include <vector>

#include "verdict/quantity_verdict.h"

#include "stages/data_check.h"

namespace tribolog {

/// Lowers the quantities that the failing checks touch, with the check's words as the reason.
/// @param has_runs runs at constant speed were recorded: friction then rests on them, not on the
///        sweep.
/// @param mass_from_sweep the recommended mass is the sweep's.
void apply_data_checks(const DataChecksResult& checks, bool has_runs, bool mass_from_sweep,
                       std::vector<QuantityVerdict>& quantities);

}  // namespace tribolog
