#pragma once
// Figures 13 and 14: driving torque against joint angle, with its maximum.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"
#include "joint/dataset.h"

namespace tribolog::figures {

/// Figure 13: the rough sweep, both directions in one panel. Absent if the stage found nothing.
std::optional<ReportFigure> rough_torque_figure(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration);

/// Figure 14: the precise sweep. Each direction has its own panel: the curvature at the peak is a
/// ten-thousandth of the friction that lies between the directions.
std::optional<ReportFigure> precise_torque_figure(const joint::Dataset& dataset,
                                                  const calibration::Calibration& calibration);

}  // namespace tribolog::figures
