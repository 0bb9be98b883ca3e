#pragma once
// Internal to the session stage: friction of oscillations from the work of each cycle.

#include <vector>

#include "joint/recording.h"
#include "method/session/friction_drift.h"
#include "method/session/session_times.h"

namespace tribolog::method::session {

/// Two levels for each oscillation that repeats itself: from its first and its second half.
/// Oscillations at about the same angle, of the same amplitude and frequency, are one family.
std::vector<FrictionLevel> oscillation_levels(const std::vector<joint::Recording>& recordings,
                                              const SessionTimes& times);

}  // namespace tribolog::method::session
