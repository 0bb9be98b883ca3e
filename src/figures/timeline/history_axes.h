#pragma once
// Internal to the history's figures: axes of time and of a quantity.

#include <string>

#include "wording/axis_scale.h"

namespace tribolog::figures::timeline {

/// Days since 1970-01-01 of "2026-01-31T12:00:00Z"; NaN for anything else.
double day_of(const std::string& utc);

/// Angles in degrees, torques and what is made of them with a prefix, all else as it is.
wording::AxisScale quantity_axis(const std::string& unit, double largest);

/// What an archived quantity is called: "Coulomb torque", "Friction at 10 rad/s".
std::string quantity_words(const std::string& name, const std::string& words);

}  // namespace tribolog::figures::timeline
