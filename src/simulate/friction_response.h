#pragma once
// A friction model with memory under prescribed motion: its torque over time.

#include <span>

#include "friction/dynamic_friction.h"
#include "simulate/motion.h"

namespace tribolog::simulate {

/// Advances the model from sample to sample; an interval in which the motion reverses is cut there.
/// @param motion of the shaft the friction acts on.
/// @param t0_s time of the first sample, dt_s sampling interval > 0.
/// @param state in: at t0_s; out: at the last sample.
/// @param torque_Nm out: friction torque at t0, t0 + dt, ...; its size is the number of samples.
/// @throw std::invalid_argument if dt_s is not > 0 or the state is not of the model's size.
void friction_response(const friction::DynamicFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, std::span<double> state, std::span<double> torque_Nm);

}  // namespace tribolog::simulate
