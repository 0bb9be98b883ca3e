#pragma once
// Internal to the verdict's rules: those on what bears on angle and gravity torque.

#include <vector>

#include "verdict/rules.h"

namespace tribolog::verdict {

/// In the order of weight.
std::vector<Rule> gravity_rules();

/// Whether gravity is too small against friction for its torque and angle to be known.
bool is_without_gravity(const calibration::Calibration& calibration);

}  // namespace tribolog::verdict
