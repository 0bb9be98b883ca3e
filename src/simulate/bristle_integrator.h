#pragma once
// The bristle equation of LuGre, eq. (4), under prescribed motion, in one pass.
//
// Exponential, 4th order (exponential_step.h); split at every reversal of the motion, halved where
// the Stribeck curve bends too sharply within a step. Stiffness sets no bound on the step.

#include <span>

#include "friction/lugre.h"
#include "simulate/motion.h"

namespace tribolog::simulate {

/// @param motion of the motor shaft.
/// @param t0_s time of the first sample, dt_s sampling interval > 0.
/// @param z0_rad deflection at t0_s.
/// @param z_rad out: mean deflection at t0, t0 + dt, ...; its size is the number of samples.
/// @param dz_rad_s out: its rate there; as many as z_rad.
/// @throw std::invalid_argument if dt_s is not > 0, z0_rad not finite or the sizes differ.
void integrate_bristle(const friction::LuGreFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, double z0_rad, std::span<double> z_rad,
                       std::span<double> dz_rad_s);

}  // namespace tribolog::simulate
