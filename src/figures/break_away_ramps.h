#pragma once
// The break-away ramps: travel of the joint against the torque, on a logarithmic scale, so that
// creep in pre-sliding and the slip are both seen.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"
#include "joint/dataset.h"

namespace tribolog::figures {

/// None where no ramp was recorded.
std::optional<ReportFigure> break_away_figure(const Dataset& dataset,
                                              const Calibration& calibration);

}  // namespace tribolog::figures
