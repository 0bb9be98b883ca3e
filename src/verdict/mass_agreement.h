#pragma once
// Internal to the verdict: do independent ways to the mass agree? Results of cross-checks enter the
// verdict here.

#include <string>
#include <vector>

#include "calibration.h"

namespace tribolog {

/// One sentence for each disagreement that the intervals do not explain; empty: none.
std::vector<std::string> mass_disagreements(const Calibration& c);

}  // namespace tribolog
