#pragma once
// Joints that are grossly not the paper's. A check of print that none of them fails says nothing
// about the joint.

#include <string>
#include <vector>

#include "paper/checks/papers_joint.h"

namespace tribolog::paper::paper_checks_test {

/// The paper's joint, or what it draws, with one thing wrong.
struct WrongJoint {
  std::string name;  ///< "σ₀ × 2"
  simulate::Scenario scenario;
  checks::DrawnLaws laws;
};

std::vector<WrongJoint> wrong_joints(const checks::PapersJoint& joint);

/// A check of print, and the wrong joints that fail it.
struct FailedBy {
  std::string item;   ///< "Table 2"
  std::string check;  ///< Check::what
  std::vector<std::string> joints;
};

struct WrongJointsResult {
  std::vector<FailedBy> checks;        ///< Every check of print, in the order of the paper.
  std::vector<std::string> unnoticed;  ///< Wrong joints that fail none: print cannot tell them.
};

/// Makes every check of print of the paper's joint on each wrong one.
/// @throw std::logic_error if a wrong joint has not as many checks of print as the right one.
WrongJointsResult try_wrong_joints(const checks::PapersJoint& joint,
                                   const std::vector<WrongJoint>& wrong);

}  // namespace tribolog::paper::paper_checks_test
