#pragma once
// Figures 18 and 19: friction against motor speed, one curve for each candidate mass.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Figure 18: all candidates over signed motor speed. Absent without runs.
std::optional<ReportFigure> friction_curves_figure(const Calibration& calibration);

/// Figure 19: the same with the reference, and below it the difference to the reference, closed up
/// on the candidates that come near. Absent without a reference.
std::optional<ReportFigure> friction_against_reference_figure(const Calibration& calibration);

}  // namespace tribolog::figures
