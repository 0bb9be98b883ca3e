#pragma once
// The surrogate mass by every way, with both intervals.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// One place for each way, numbered as in the report's table. Absent with fewer than two ways.
std::optional<ReportFigure> mass_comparison_figure(const Calibration& calibration);

}  // namespace tribolog::figures
