#pragma once
// Loops of a joint that a torque drives: the motion is the answer, no sine and not periodic.

#include <functional>
#include <vector>

#include "method/hysteresis/lugre_fit.h"
#include "simulate/scenario.h"

namespace tribolog::test {

/// A torque about the one that holds the arm [N·m, motor] by time [s].
using DrivingTorque = std::function<double(double t_s)>;

/// A sine that grows from loop to loop, from amplitude `first` to `last` [N·m].
DrivingTorque growing_sine(double first_Nm, double last_Nm, double frequency_Hz, double duration_s);
/// The same of straight strokes.
DrivingTorque growing_triangle(double first_Nm, double last_Nm, double frequency_Hz,
                               double duration_s);

/// The joint of the scenario at its gravity peak, from an unloaded contact, without noise.
joint::Recording torque_driven_loop(const simulate::Scenario& joint, const DrivingTorque& torque,
                                    double duration_s, double sample_rate_Hz);

/// Fitted along their traced motions.
method::hysteresis::LuGreFit fit_traced(const std::vector<joint::Recording>& loops);

}  // namespace tribolog::test
