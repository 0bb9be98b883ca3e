#pragma once
// The torques of the loop's six points by ways that share nothing with the program's reading of a
// log: in closed form, and by an implicit solver.

#include <array>

#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// Torques at the motor [N·m] of A, B, C, D, E, F in the first turn, from z = 0 at q_peak, of the
/// joint without inertia and without Stribeck effect: in closed form.
std::array<double, 6> plain_loop_torques_Nm(const simulate::Scenario& scenario);

Checks check_loop_torques(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
