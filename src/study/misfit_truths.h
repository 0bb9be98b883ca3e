#pragma once
// Internal to the studies of misfit: what an error-free identification would find.

#include <map>
#include <vector>

#include "joint/quantity.h"
#include "simulate/scenario.h"
#include "simulate/simulate_joint.h"

namespace tribolog::study {

/// By the verdict's keys; SI, motor side; NaN: there is none. Where friction changes with load,
/// angle or time, Coulomb, viscous and break-away torque are those at the mean of the runs, over a
/// whole turn of the motor, stiffness and damping those at the oscillations. Of a load that changes
/// it is the gravity before, and where the controller keeps some of it to itself, what the log has.
/// @param undisturbed scenario. @param laid the same with what was laid on it.
/// @param ideal recordings of that.
std::map<joint::Quantity, double> truths_of(const simulate::Scenario& undisturbed,
                                            const simulate::Scenario& laid,
                                            const std::vector<simulate::IdealRecording>& ideal);

}  // namespace tribolog::study
