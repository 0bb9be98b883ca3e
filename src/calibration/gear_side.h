#pragma once
// Results on either side of the gear. With the gear ratio n = motor angle / joint angle:
// torque at the joint = n times that at the motor; speed and angle 1/n; coefficients of torque per
// angle, per speed and per acceleration (stiffness, damping, inertia) n².

#include <optional>
#include <string>
#include <vector>

#include "calibration/archived_calibration.h"
#include "joint/drive.h"

namespace tribolog::calibration {

/// A result on a stated side.
struct SidedQuantity {
  Quantity quantity;
  joint::Side side{joint::Side::motor};
  int gear_power{};  ///< From the archived number: times the gear ratio to this power.
};

/// How often the gear ratio enters from the motor's side to the joint's; 0: the quantity is of the
/// joint alone (angle of the centre of gravity, surrogate mass).
/// @return nothing for a quantity that is not known.
std::optional<int> gear_power(const std::string& quantity);

/// Each quantity that has a unit on both sides, or on the one that it belongs to.
std::vector<SidedQuantity> on_both_sides(const std::vector<Quantity>& quantities,
                                         double gear_ratio);

/// The quantity at the joint.
statistics::Estimate at_joint(const Quantity& quantity, double gear_ratio);

/// "Inertia at the motor" is "Inertia": the side stands beside it.
std::string without_side(const std::string& words);

/// "as archived", "archived × n²", "archived / n".
std::string conversion_words(int gear_power);

}  // namespace tribolog::calibration
