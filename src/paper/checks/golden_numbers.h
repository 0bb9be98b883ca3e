#pragma once
// Every number that the method's description gives for the paper and its reconstructed joint, with
// the deviation of what the program computes.

#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// Table 2 from its printed torques; the reconstruction's ratios; its torques without and with
/// inertia and Stribeck effect; the pair means; the friction curve of the runs.
Checks golden_numbers(const PapersJoint& joint);

/// Part of them: the joint's parameters and experiments, held against the scenario.
Checks golden_parameters(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
