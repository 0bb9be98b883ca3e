#pragma once
// Figure 22: the choice of driving torque and angle on the loop.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Above, the whole loop with the paper's chosen point, the mid-line, and the shift of angle of
/// eq. (14). Below, torque closed up around the mid-line: the chosen point, its steady counterpart
/// and its opposite, and the mid-line with its interval. Absent without a loop, or without both a
/// chosen point and a mid-line.
std::optional<ReportFigure> torque_choice_figure(const calibration::Calibration& calibration);

}  // namespace tribolog::figures
