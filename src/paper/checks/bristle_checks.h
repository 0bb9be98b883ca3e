#pragma once
// The bristle equation (4) under the oscillation by SUNDIALS' CVODE: a solver that shares nothing
// with the program's own integrator.

#include <vector>

#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// z [rad] at the samples of the joint's oscillation, from z = 0.
/// @throw std::runtime_error if the solver gives up.
std::vector<double> solved_deflection_rad(const PapersJoint& joint);

/// Time of the first downward zero of z [s]: the instant of point B.
double solved_time_of_B_s(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
