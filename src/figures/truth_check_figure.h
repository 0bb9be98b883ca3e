#pragma once
// The known-truth check: what came back less what was put in, in units of the stated half width.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Stage "known-truth". Absent if the check was not made or nothing came back.
std::optional<ReportFigure> truth_check_figure(const Calibration& calibration);

}  // namespace tribolog::figures
