#pragma once
// What the paper claims, as hypotheses: each is put to a simulated joint, whose truth is known, and
// may hold there or not.

#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "joint/dataset.h"
#include "simulate/scenario.h"

namespace tribolog::paper::claims {

/// A joint with what was simulated of it and identified from that.
struct ArguedJoint {
  simulate::Scenario scenario;
  joint::Dataset dataset;
  calibration::Calibration calibration;

  /// @throw Refusal, std::invalid_argument: what cannot be simulated.
  explicit ArguedJoint(const simulate::Scenario& scenario);
};

/// What was found of a claim on one joint.
struct Finding {
  std::optional<bool> holds;  ///< Absent: the joint's experiments do not ask it.
  std::string found;          ///< In words, or why it cannot be asked.
};

struct Claim {
  bool is_ours{};     ///< Of this program; else of the paper.
  std::string where;  ///< "3.2", "conclusion"
  std::string what;
  Finding on_papers_joint;
  Finding on_this_joint;
};

/// In the order of the paper, ours last.
std::vector<Claim> put_claims(const ArguedJoint& papers, const ArguedJoint& other);

}  // namespace tribolog::paper::claims
