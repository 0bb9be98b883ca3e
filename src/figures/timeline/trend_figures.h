#pragma once
// A quantity of a joint over time, and its CUSUM below.

#include <vector>

#include "figures/report_figure.h"
#include "history/joint_trend.h"

namespace tribolog::figures::timeline {

/// "trend-1-friction": friction of the first joint at all speeds in percent of its reference, above
/// all else. Then one figure for each other quantity with a point, those with a change first;
/// "trend-1-1" is that of the first quantity of the first joint: values with their intervals, the
/// reference with its scatter, what was left out, the date from which a change is visible; below
/// the sums and their limit, where any are.
std::vector<ReportFigure> trend_figures(const std::vector<history::JointTrend>& trends);

}  // namespace tribolog::figures::timeline
