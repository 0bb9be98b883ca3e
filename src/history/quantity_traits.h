#pragma once
// What a quantity depends on beside the joint's state: what has to be alike before two values of it
// can be compared.

#include <string>

#include "calibration/archived_calibration.h"

namespace tribolog::history {

struct QuantityTraits {
  /// Friction lives in the lubricant: viscous and Coulomb friction change by about 1 % for each
  /// kelvin. Gravity, inertia and the stiffness of metal hardly do.
  bool depends_on_temperature{true};
  /// Gravity torque, its angle, the surrogate mass and the inertia hold the payload.
  bool depends_on_payload{true};
  /// Read from a fast change of the torque; a slow log rounds it off.
  bool depends_on_sampling{true};
  bool is_angle{false};  ///< Its zero is a convention: a change in percent has no meaning.
};

/// @param name as in the archive: "coulomb_torque". One that is not known depends on everything.
QuantityTraits traits_of(const std::string& name);

// What of two calibrations' conditions is the same.

bool has_same_gear(const calibration::Facts& a, const calibration::Facts& b);
/// Name, mass and distance; one that is stated and one that is not are two.
bool has_same_payload(const calibration::Facts& a, const calibration::Facts& b);

}  // namespace tribolog::history
