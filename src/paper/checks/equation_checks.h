#pragma once
// The paper's fourteen equations, each held against what the program computes.
//
// The reference is written here from the paper's page, as corrected by the errata, or is a
// consequence that has to hold; the other side is what the program uses everywhere else.

#include "paper/checks/check.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper {

Checks check_equation_1(const PapersJoint& joint);
Checks check_equation_2(const PapersJoint& joint);
Checks check_equation_3(const PapersJoint& joint);
Checks check_equation_4(const PapersJoint& joint);
Checks check_equation_5(const PapersJoint& joint);
Checks check_equation_6(const PapersJoint& joint);
Checks check_equation_7(const PapersJoint& joint);
Checks check_equation_8(const PapersJoint& joint);
Checks check_equation_9(const PapersJoint& joint);
Checks check_equation_10(const PapersJoint& joint);
Checks check_equation_11(const PapersJoint& joint);
Checks check_equation_12(const PapersJoint& joint);
Checks check_equation_13(const PapersJoint& joint);
Checks check_equation_14(const PapersJoint& joint);

}  // namespace tribolog::paper
