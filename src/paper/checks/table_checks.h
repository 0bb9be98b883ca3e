#pragma once
// The paper's two tables, row by row.

#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper {

/// The six parameters that figure 5 is simulated with, against those that the paper cites.
Checks check_table_1();
/// Six torques of the simulated joint; six masses from the printed torques; six from its own.
Checks check_table_2(const PapersJoint& joint);

}  // namespace tribolog::paper
