#pragma once
// Internal to the verdict's rules: those on what affects the angle of the centre of gravity and the
// gravity torque.

#include <vector>

#include "verdict/rules.h"

namespace tribolog::verdict {

/// Most important first.
std::vector<Rule> gravity_rules();

/// Whether the manifest states that there is no gravity torque.
bool has_stated_no_gravity(const calibration::Calibration& calibration);

/// Of a joint whose manifest states none: why.
Statement why_no_gravity(const calibration::Calibration& calibration);

/// Whether there are friction points but no recordings.
bool has_points_alone(const calibration::Calibration& calibration);

/// Whether gravity is too small relative to friction for its torque and angle to be known.
bool is_without_gravity(const calibration::Calibration& calibration);

}  // namespace tribolog::verdict
