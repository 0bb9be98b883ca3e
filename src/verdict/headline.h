#pragma once
// The sentence at the top of the report: what is known and how well, then what decides against it.

#include "base/statement.h"
#include "calibration/calibration.h"

namespace tribolog::verdict {

/// @param judgement all of it but sentence and findings.
/// @param without_gravity the joint is judged by its friction alone.
Statement headline(const calibration::Calibration& c, const calibration::Judgement& judgement,
                   bool without_gravity);

}  // namespace tribolog::verdict
