#pragma once
// What the viscous curve, the runs and the sweep show beyond their numbers, for the verdict.

#include <string>
#include <vector>

#include "calibration/calibration.h"

namespace tribolog::verdict {

/// Most important first; empty if there is nothing that the reader must know.
std::vector<Statement> curve_findings(const calibration::Calibration& calibration);

/// Which model to use where the curve does not support Waiboer's five parameters; else empty. No
/// number rests on it.
Statement which_model(const calibration::Calibration& calibration);

}  // namespace tribolog::verdict
