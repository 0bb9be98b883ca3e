#pragma once
// Figures of the bristle's parameters: LuGre on the loop, and the break-away ramps.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"
#include "joint/dataset.h"

namespace tribolog::figures {

/// Not one of the paper's. Nothing if no fit converged.
std::optional<ReportFigure> lugre_loop_figure(const calibration::Calibration& calibration);

// The break-away ramps: travel of the joint against the torque, on a logarithmic scale, so that
// creep in pre-sliding and the slip are both seen.

/// None where no ramp was recorded.
std::optional<ReportFigure> break_away_figure(const joint::Dataset& dataset,
                                              const calibration::Calibration& calibration);

}  // namespace tribolog::figures
