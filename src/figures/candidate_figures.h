#pragma once
// Figures 18 to 20: the friction curve of each candidate mass, and its error.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Not one of the paper's: figures 18 to 20 in one. The candidates with the reference, the
/// recommended one emphasised, and below their error in % of the driving torque; those far off are
/// left out and named. Without a reference the candidates alone; absent without runs.
std::optional<ReportFigure> friction_candidates_figure(const calibration::Calibration& calibration);

/// Figure 18: all candidates over signed motor speed. Absent without runs.
std::optional<ReportFigure> friction_curves_figure(const calibration::Calibration& calibration);

/// Figure 19: the same with the reference, and below it the difference to the reference, closed up
/// on the candidates that come near. Absent without a reference.
std::optional<ReportFigure> friction_against_reference_figure(
    const calibration::Calibration& calibration);

// Figure 20: the error of each candidate's friction curve in % of the driving torque.

/// All candidates over motor speed, and below a close-up of those near the selected ones where the
/// others would flatten them. Absent without errors.
std::optional<ReportFigure> quality_error_figure(const calibration::Calibration& calibration);

}  // namespace tribolog::figures
