#pragma once
// A comparison as JSON for scripts.

#include <string>

#include "history/comparison.h"

namespace tribolog::history {

/// Schema "tribolog-archive-diff-1": SI, motor side. The same comparison gives the same bytes.
std::string comparison_json(const Comparison& comparison);

}  // namespace tribolog::history
