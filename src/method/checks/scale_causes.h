#pragma once
// What makes a logged signal wrong by a factor, and the holding torque of the load against its
// weight.

#include <optional>

#include "base/statement.h"
#include "joint/dataset.h"
#include "joint/drive.h"
#include "method/checks/data_check.h"
#include "statistics/estimate.h"

namespace tribolog::method::checks {

/// The usual causes of a factor logged / true of a speed, all that fit; states if none does.
/// @param half_width of the factor, 95 %.
Statement likely_cause_of_scale(double factor, double half_width, double gear_ratio);

/// The same for a torque, found / true: unit, side of the gear, torque constant. The true value is
/// known only to a few per cent.
Statement likely_cause_of_torque_scale(double factor, double half_width, const joint::Drive& drive);

// Internal to the checks: the holding torque of the load compared with its weight.

/// Gravity as found, motor side.
struct FoundGravity {
  statistics::Estimate amplitude_Nm;
  double q_peak_rad{};
};

/// Compares the gravity found with that stated ([known_gravity]), or else with the least that a
/// stated payload causes, m g r. Names what makes a torque wrong by such a factor.
DataCheck check_static_torque(const joint::Manifest& manifest,
                              const std::optional<FoundGravity>& found);

}  // namespace tribolog::method::checks
