#pragma once
// What two calibrations recorded, drawn over each other.

#include <vector>

#include "figures/report_figure.h"
#include "history/comparison.h"
#include "history/recorded_curves.h"

namespace tribolog::figures {

/// "diff-friction": friction over speed, "diff-loop": the first steady loop over the angle; each
/// only where both calibrations hold it.
std::vector<ReportFigure> comparison_figures(const history::Comparison& comparison,
                                             const history::RecordedCurves& first,
                                             const history::RecordedCurves& second);

}  // namespace tribolog::figures
