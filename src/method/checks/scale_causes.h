#pragma once
// What makes a logged signal wrong by a factor, and the torque that holds the load against its
// weight.

#include <optional>

#include "base/statement.h"
#include "joint/dataset.h"
#include "joint/drive.h"
#include "method/checks/data_check.h"
#include "statistics/estimate.h"

namespace tribolog::method::checks {

/// The usual causes of a factor logged / true of a speed; where none fits, that none does. Several
/// that fit are all stated.
/// @param half_width of the factor, 95 %.
Statement likely_cause_of_scale(double factor, double half_width, double gear_ratio);

/// The same of a torque, found / true: unit, side of the gear, torque constant. What is true is
/// known to some per cent only.
Statement likely_cause_of_torque_scale(double factor, double half_width, const joint::Drive& drive);

// Internal to the checks: the torque that holds the load against what the load weighs.

/// Gravity as it was found, motor side.
struct FoundGravity {
  statistics::Estimate amplitude_Nm;
  double q_peak_rad{};
};

/// Gravity that was found against the one stated ([known_gravity]), or else against the least that
/// a stated payload makes, m g r. Names what makes a torque wrong by such a factor.
DataCheck check_static_torque(const joint::Manifest& manifest,
                              const std::optional<FoundGravity>& found);

}  // namespace tribolog::method::checks
