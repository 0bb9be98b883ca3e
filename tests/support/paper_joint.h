#pragma once
// The paper's joint, reconstructed, as known truth: the same numbers as
// examples/paper/scenario.toml (a test holds the two together).

#include <cstdint>

#include "friction/lugre.h"
#include "friction/static_laws.h"
#include "simulate/scenario.h"
#include "simulate/simulate_joint.h"

namespace tribolog::test {

/// Gravity torque at the motor with the centre of gravity horizontal [N·m].
inline constexpr double true_gravity_Nm = 3.88318571;
/// Surrogate mass at 0.5 m that it stands for [kg].
inline constexpr double true_surrogate_mass_kg = 79.1679;
/// Angle of the gravity peak [rad].
double true_q_peak_rad();

/// Its friction in the oscillation.
friction::LuGreFriction paper_contact();
/// Its friction in sweeps and runs.
friction::WaiboerFriction paper_curve();

/// The four experiments, noise-free.
simulate::Scenario paper_joint();
/// The same with the noise of a real drive, ten cycles, and no bristle deflection in the log.
simulate::Scenario noisy_paper_joint(std::uint64_t seed);

using simulate::simulated_dataset;

}  // namespace tribolog::test
