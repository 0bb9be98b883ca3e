#pragma once
// Break-away ramps of a scenario: the joint stands, its drive holds gravity, and the torque rises
// slowly until the joint slides. Here the motion is the answer:
//
//   (J + I/n^2) dw/dt = T(t) - Tf - (m g r / n) cos(q - q_peak),      phi = n q

#include <string>

#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog::simulate {

/// One ramp from an unloaded contact, without the noise of a drive. It ends where the torque has
/// changed by largest_torque_Nm, or the joint has travelled largest_travel_rad.
/// @param direction +1 or -1, of the torque.
/// @throw Refusal for a ramp that cannot be carried out, or a joint without inertia.
joint::Recording simulate_break_away_ramp(const Scenario& scenario, const BreakAwayExperiment& ramp,
                                          double direction, std::string name);

}  // namespace tribolog::simulate
