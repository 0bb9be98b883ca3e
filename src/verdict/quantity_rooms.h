#pragma once
// Internal to the verdict: its quantities, one source file for each family. Each states what the
// stages found and what they could not find; data checks and limits are added in judge().

#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/quantity_verdict.h"

namespace tribolog::verdict {

/// Angle of the centre of gravity, gravity torque, surrogate mass.
std::vector<calibration::QuantityVerdict> gravity_verdicts(const calibration::Calibration& c);
/// Break-away torque, bristle stiffness, bristle damping, inertia: what the loop shows.
std::vector<calibration::QuantityVerdict> bristle_verdicts(const calibration::Calibration& c);
/// Coulomb torque, Stribeck velocity, viscous coefficient, viscous curve: what the runs show.
std::vector<calibration::QuantityVerdict> curve_verdicts(const calibration::Calibration& c);

/// By the whole expanded interval, once all that is stated is in it: an angle that is known to no
/// more than 5° is doubtful, to no more than 30° none; any other number by 30 % of itself.
void doubt_wide_intervals(std::vector<calibration::QuantityVerdict>& all);

/// From the runs, or else from the sweep; motor side [N·m].
std::optional<statistics::Estimate> coulomb_torque(const calibration::Calibration& c);

/// The verdict on one quantity. @param all holds it.
calibration::QuantityVerdict& verdict_on(joint::Quantity quantity,
                                         std::vector<calibration::QuantityVerdict>& all);

/// Whether the manifest states that there is no gravity torque.
bool has_stated_no_gravity(const calibration::Calibration& calibration);

/// Of a joint whose manifest states none: why.
Statement why_no_gravity(const calibration::Calibration& calibration);

/// Whether there are friction points but no recordings.
bool has_points_alone(const calibration::Calibration& calibration);

/// What to record for each family.
inline constexpr Code record_a_sweep{"record.sweep"};
inline constexpr Code record_an_oscillation{"record.oscillation"};
inline constexpr Code record_runs{"record.runs"};

/// The verdict on a positive quantity by its estimate: not identifiable where that is absent or its
/// interval reaches zero; doubtful where the interval is wider than 30 % of it. judge() adds the
/// unit.
/// @param why_absent where there is no estimate.
calibration::QuantityVerdict by_estimate(joint::Quantity quantity,
                                         const std::optional<statistics::Estimate>& estimate,
                                         const Statement& why_absent, const Statement& experiment);

}  // namespace tribolog::verdict
