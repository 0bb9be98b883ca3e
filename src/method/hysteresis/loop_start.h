#pragma once
// How a drive starts a loop: a sine that begins with its full speed asks for a blow, many times the
// loop's torque, for as long as the drive needs to catch up. No motion that is read from the angle
// resolves the acceleration within it, and least squares would bend the model after it.

#include "joint/recording.h"

namespace tribolog::method::hysteresis {

/// Time since the first sample before which the drive still starts the motion [s]; 0 where no
/// torque of the first cycle leaves the range of the later ones: a LuGre joint that starts from any
/// deflection stays within its loop.
/// @param period_s of a cycle.
double settled_from_s(const joint::Recording& recording, double period_s);

}  // namespace tribolog::method::hysteresis
