#pragma once
// All checks on the data of one joint; data_check.h says what a check is.

#include <optional>
#include <vector>

#include "joint/dataset.h"
#include "method/checks/data_check.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/surrogate_masses.h"
#include "statistics/estimate.h"

namespace tribolog::method::checks {

/// Checks that need only the recordings. Without a torque those on torque are not applicable; those
/// on motion still run.
DataChecksResult check_recordings(const joint::Dataset& dataset);

/// What the recordings show of gravity.
struct GravityResults {
  const gravity::CogSweepResult& rough;  ///< The sweep whose amplitude is used in later stages.
  const hysteresis::SurrogateMassesResult& masses;
  const std::optional<statistics::Estimate>& q_peak_rad;
};

/// Adds the checks that need angle and size of gravity: whether the oscillation is at the gravity
/// peak, and whether the gravity found is plausible.
void add_gravity_checks(const joint::Dataset& dataset, const GravityResults& gravity,
                        DataChecksResult& result);

}  // namespace tribolog::method::checks
