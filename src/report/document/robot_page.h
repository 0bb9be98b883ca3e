#pragma once
// A whole robot on one page: each joint's verdict, key numbers, change and pictures, and the way to
// its report. One HTML file without script.

#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "history/comparison.h"
#include "wording/language.h"

namespace tribolog::report::document {

struct RobotJoint {
  std::string name;
  const calibration::Calibration* calibration{nullptr};  ///< Null: it could not be identified,
  std::string refusal;                                   ///< for this reason.
  std::optional<history::Comparison> since_last;
  std::string file;  ///< Of its report, beside the page; empty: there is none.
};

/// @param joints in the manifest's order; the worst verdict is the robot's. Verdicts and numbers
/// are
///        embedded as JSON, schema "tribolog-robot-result-1", in the element "tribolog-robot": SI,
///        motor side, intervals with what the manifest states of uncertainty.
std::string robot_page(const std::vector<RobotJoint>& joints,
                       const calibration::Provenance& provenance,
                       wording::Language language = wording::Language{});

}  // namespace tribolog::report::document
