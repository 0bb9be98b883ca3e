#pragma once
// What two calibrations recorded, drawn over each other.

#include <vector>

#include "calibration/read_calibration.h"
#include "figures/report_figure.h"
#include "history/comparison.h"

namespace tribolog::figures::timeline {

/// "diff-friction": friction over speed, "diff-loop": the first steady loop over the angle; each
/// only where both calibrations hold it.
std::vector<ReportFigure> comparison_figures(const history::Comparison& comparison,
                                             const calibration::RecordedCurves& first,
                                             const calibration::RecordedCurves& second);

}  // namespace tribolog::figures::timeline
