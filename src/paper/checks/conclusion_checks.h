#pragma once
// What the paper concludes in words, held against the simulated joint.

#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper {

Checks check_conclusions(const PapersJoint& joint);

}  // namespace tribolog::paper
