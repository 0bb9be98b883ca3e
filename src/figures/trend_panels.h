#pragma once
// Internal to the figures of a trend: its two panels, over one axis of dates.

#include "history/joint_trend.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// Whether temperature's effect is more than what chance makes of none; only then are values shown
/// as brought to one temperature.
bool is_visibly_corrected(const history::QuantityTrend& trend);

/// Values with intervals, the reference, what was left out, the dates of changes.
/// @param trend with at least one point.
render::Panel trend_panel(const history::QuantityTrend& trend, const AxisScale& scale);

/// Both sums of the chart and their limit.
render::Panel sum_panel(const history::QuantityTrend& trend);

}  // namespace tribolog::figures
