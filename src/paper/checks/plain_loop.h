#pragma once
// The loop's six torques in closed form, for the joint without inertia and Stribeck effect.
//
// With g constant, eq. (4) is linear along the way: between reversals z goes to ±g like
// exp(-way/g). The points follow without a solver and without samples.

#include <array>

#include "paper/checks/papers_joint.h"

namespace tribolog::paper {

/// Torques at the motor [N·m] of A, B, C, D, E, F in the first turn, from z = 0 at q_peak.
std::array<double, 6> plain_loop_torques_Nm(const Scenario& scenario);

}  // namespace tribolog::paper
