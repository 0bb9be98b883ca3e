#pragma once
// What a figure prints a reading as, and the shaft that speeds and torques are referred to, in
// words.

#include <string>

#include "joint/dataset.h"

namespace tribolog::wording {

/// The reading's words with the subscript marked up: "break-away torque T_{s}".
std::string reading_label(const std::string& reading);

// A joint without a gear, or one whose log and gain are stated at the joint, has no motor side of
// its own.

/// False where the gear ratio is 1.
bool has_motor_side(const joint::Manifest& manifest);

/// "motor", or "joint" where the gear ratio is 1.
std::string shaft(const joint::Manifest& manifest);

/// "φ̇", or "q̇" where the gear ratio is 1.
std::string speed_symbol(const joint::Manifest& manifest);

/// "motor speed φ̇", or "joint speed q̇" where the gear ratio is 1.
std::string speed_quantity(const joint::Manifest& manifest);

/// "size of motor speed φ̇", for an axis on which both directions count as positive.
std::string speed_size(const joint::Manifest& manifest);

}  // namespace tribolog::wording
