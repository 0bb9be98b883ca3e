#pragma once
// Internal to the verdict's rules: those on what bears on angle and gravity torque.

#include <vector>

#include "verdict/rules.h"

namespace tribolog::verdict {

/// In the order of weight.
std::vector<Rule> gravity_rules();

/// Whether the manifest says that there is none.
bool has_stated_no_gravity(const calibration::Calibration& calibration);

/// Whether there is no recording, but friction points.
bool has_points_alone(const calibration::Calibration& calibration);

/// Whether gravity is too small against friction for its torque and angle to be known.
bool is_without_gravity(const calibration::Calibration& calibration);

}  // namespace tribolog::verdict
