#pragma once
// Joints that are grossly not the paper's. A check of print that none of them fails says nothing
// about the joint.

#include <cstddef>
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

/// For each check of print, in the order of items_of_print(), the places of the wrong joints that
/// fail it.
using FailedByPlace = std::vector<std::vector<std::size_t>>;

/// @param progress is told how many joints are done, and of how many.
/// @throw std::logic_error if a wrong joint has not as many checks of print as the right one.
FailedByPlace try_wrong_joints(const PapersJoint& joint, const std::vector<WrongJoint>& wrong,
                               const std::function<void(std::size_t, std::size_t)>& progress = {});

/// The same in the words of the language that is set.
/// @param wrong those that were tried.
WrongJointsResult in_words(const PapersJoint& joint, const std::vector<WrongJoint>& wrong,
                           const FailedByPlace& failed);

}  // namespace tribolog::paper::checks
