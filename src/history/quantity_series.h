#pragma once
// Internal to the history: the values of each quantity over the calibrations of a joint, and which
// of them belong together.

#include <string>
#include <vector>

#include "history/joint_trend.h"

namespace tribolog::history {

/// All quantities that have an estimate at least once, without their charts.
/// @param calibrations of one joint, in time.
/// @param from what was measured before is left out; empty: nothing.
std::vector<QuantityTrend> quantity_series(const std::vector<calibration::Measured>& calibrations,
                                           const std::string& from);

/// For the chart: the interval as a standard error.
SeriesPoint series_point(const HistoryPoint& point);

/// Empty unless the temperature rose or fell along with time, so that a drift cannot be separated
/// from it.
Statement caution_on_warming(const std::vector<calibration::Measured>& calibrations);

}  // namespace tribolog::history
