#pragma once
// What a failing check on the data does to each quantity.

#include <vector>

#include "calibration/quantity_verdict.h"
#include "method/checks/data_check.h"

namespace tribolog {

/// Which recordings the quantities come from: a failing check of others does not touch them.
struct Sources {
  bool friction_from_runs{};     ///< Runs at constant speed, not the sweep.
  bool mass_from_sweep{};        ///< The recommended mass is the sweep's.
  bool break_away_from_ramps{};  ///< Not from the oscillation.
};

/// Lowers the quantities that the failing checks touch, with the check's words as the reason.
void apply_data_checks(const DataChecksResult& checks, const Sources& sources,
                       std::vector<QuantityVerdict>& quantities);

}  // namespace tribolog
