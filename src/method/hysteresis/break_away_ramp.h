#pragma once
// What one break-away ramp shows: where its torque begins to rise, where the joint begins to slide,
// friction there and the level to which friction at rest tends. See break_away.h for the method.

#include "joint/recording.h"
#include "method/hysteresis/break_away.h"

namespace tribolog::method::hysteresis {

/// A LuGre contact is seen to yield at this share of its static torque.
inline constexpr double share_at_reading = 0.993;

/// @param r of three samples or more. @param result says what gravity is taken off.
/// @param inertia_at_joint as identify_break_away(). @param behind_s of the bristle's torque
/// (BehindTorque).
BreakAwayRamp read_ramp(const joint::Recording& r, const BreakAwayResult& result,
                        double inertia_at_joint, double behind_s);

}  // namespace tribolog::method::hysteresis
