#pragma once
// Internal to the checks: torque ripple as the sweep's residual shows it.

#include "joint/dataset.h"
#include "method/checks/data_check.h"
#include "method/gravity/cog_sweep.h"

namespace tribolog {

/// Whether the oscillations' positions average the ripple out.
DataCheck check_torque_ripple(const Dataset& dataset, const CogSweepResult& sweep);

/// Whether the ripple repeats a whole number of times a motor turn, as the stated gear ratio has
/// it.
DataCheck check_ripple_period(const Dataset& dataset, const CogSweepResult& sweep);

}  // namespace tribolog
