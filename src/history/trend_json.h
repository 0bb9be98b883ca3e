#pragma once
// Trends as JSON for scripts.

#include <string>
#include <vector>

#include "history/joint_trend.h"

namespace tribolog::history {

/// Schema "tribolog-archive-trend-1": SI, motor side. The same trends give the same bytes.
std::string trend_json(const std::vector<JointTrend>& trends);

}  // namespace tribolog::history
