#pragma once
// Joints that are grossly not the paper's. A check of print that none of them fails says nothing
// about the joint.

#include <functional>
#include <string>
#include <vector>

#include "paper/checks/check.h"
#include "paper/checks/paper_items.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// The paper's joint, or what it draws, with one thing wrong.
struct WrongJoint {
  std::string name;  ///< "σ₀ × 2"
  simulate::Scenario scenario;
  DrawnLaws laws;
};

std::vector<WrongJoint> wrong_joints(const PapersJoint& joint);

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

/// @param wrong joints that are tried.
/// @param progress is told how many joints are done, and of how many.
/// @throw std::logic_error if the wrong joints' checks are not those of the right one.
WrongJointsResult try_wrong_joints(
    const PapersJoint& joint, const std::vector<WrongJoint>& wrong,
    const std::function<void(std::size_t, std::size_t)>& progress = {});

}  // namespace tribolog::paper::checks
