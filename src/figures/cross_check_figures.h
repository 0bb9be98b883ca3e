#pragma once
// Figures that hold results against others: the mass by every way, and the known truth.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// A row for each way, by its name. Absent with fewer than two ways.
std::optional<ReportFigure> mass_comparison_figure(const calibration::Calibration& calibration);

// The known-truth check: what came back less what was put in, in units of the stated half width.

/// Stage "known-truth". Absent if the check was not made or nothing came back.
std::optional<ReportFigure> truth_check_figure(const calibration::Calibration& calibration);

}  // namespace tribolog::figures
