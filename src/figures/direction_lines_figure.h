#pragma once
// Each direction's friction by itself, with its straight line.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// With the stated gravity where there is one, else with the recommended. Absent where neither
/// direction has a line, and for a sweep, whose directions figure 21 shows.
std::optional<ReportFigure> direction_lines_figure(const Calibration& calibration);

}  // namespace tribolog::figures
