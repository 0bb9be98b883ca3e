#pragma once
// Figure 21: the selected friction curves against the reference, with the fitted laws.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Size of friction over size of motor speed: the paper's choice, the recommended one with the
/// interval of its runs, the reference, and the fits of stage 8. The two directions lie on each
/// other if gravity was removed rightly. Absent without a curve.
std::optional<ReportFigure> selected_curve_figure(const calibration::Calibration& calibration);

}  // namespace tribolog::figures
