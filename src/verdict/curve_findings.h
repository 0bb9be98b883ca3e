#pragma once
// What the viscous curve, the runs and the sweep show beyond their numbers, for the verdict.

#include <string>
#include <vector>

#include "calibration/calibration.h"

namespace tribolog::verdict {

/// Most important first; empty if there is nothing that the reader must know.
std::vector<Statement> curve_findings(const calibration::Calibration& calibration);

}  // namespace tribolog::verdict
