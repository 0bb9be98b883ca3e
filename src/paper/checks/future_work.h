#pragma once
// What the paper leaves to future experiments, and what of it is met here.

#include "paper/checks/paper_items.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// "A method for determining values of all parameters based only on friction hysteresis": the
/// joint's oscillation alone, without sweeps, runs and bristle deflection, as the paper has it and
/// large enough to slide, with what is found of each parameter.
PaperItem check_future_work(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
