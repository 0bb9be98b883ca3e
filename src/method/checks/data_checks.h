#pragma once
// All checks on the data of one joint; data_check.h says what a check is.

#include <optional>
#include <vector>

#include "joint/dataset.h"
#include "method/checks/data_check.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/run_gravity.h"
#include "statistics/estimate.h"

namespace tribolog::method::checks {

/// Checks that need nothing but the recordings. Without a torque those on torque are not
/// applicable; those on the motion still run.
DataChecksResult check_recordings(const joint::Dataset& dataset);

/// What the sweeps and the runs say of gravity.
struct GravityResults {
  const gravity::CogSweepResult& rough;   ///< The one whose amplitude is used further on.
  const gravity::RunGravityResult& runs;  ///< Compared with what is stated without a sweep.
  const std::optional<statistics::Estimate>& q_peak_rad;
};

/// Those, and the checks that need the place and size of gravity: whether the oscillation is at the
/// gravity peak, and whether the gravity found can be.
DataChecksResult check_recordings(const joint::Dataset& dataset, const GravityResults& gravity);

}  // namespace tribolog::method::checks
