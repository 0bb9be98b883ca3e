#pragma once
// Figure 11: what the rough sweep did over time.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"
#include "joint/dataset.h"

namespace tribolog::figures {

/// Joint angle, motor speed and driving torque over time, in three panels that share it. Samples
/// used are coloured by direction, those left out are grey. Absent without a rough sweep.
std::optional<ReportFigure> sweep_motion_figure(const joint::Dataset& dataset,
                                                const calibration::Calibration& calibration);

}  // namespace tribolog::figures
