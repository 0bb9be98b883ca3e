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

/// Checks that need the place and size of gravity, which the sweeps give: whether the oscillation
/// is at the gravity peak, and whether the gravity found can be.
/// @param sweep the one whose gravity amplitude is used further on.
/// @param runs their gravity is compared with what is stated where no sweep gave any.
void add_gravity_checks(const joint::Dataset& dataset, const gravity::CogSweepResult& sweep,
                        const gravity::RunGravityResult& runs,
                        const std::optional<statistics::Estimate>& q_peak_rad,
                        DataChecksResult& result);

}  // namespace tribolog::method::checks
