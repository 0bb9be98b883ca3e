#pragma once
// Internal to the checks: the torque that holds the load against what the load weighs.

#include <optional>

#include "joint/dataset.h"
#include "method/checks/data_check.h"
#include "statistics/estimate.h"

namespace tribolog {

/// Gravity as it was found, motor side.
struct FoundGravity {
  Estimate amplitude_Nm;
  double q_peak_rad{};
};

/// Gravity that was found against the one stated ([known_gravity]), or else against the least that
/// a stated payload makes, m g r. Names what makes a torque wrong by such a factor.
DataCheck check_static_torque(const Manifest& manifest, const std::optional<FoundGravity>& found);

}  // namespace tribolog
