#pragma once
// Figure 20: the error of each candidate's friction curve in % of the driving torque.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// All candidates over motor speed, and below a close-up of those near the selected ones where the
/// others would flatten them. Absent without errors.
std::optional<ReportFigure> quality_error_figure(const Calibration& calibration);

}  // namespace tribolog::figures
