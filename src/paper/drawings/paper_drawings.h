#pragma once
// The paper's figures that are drawings: 3, 4, 6, 7 and 8.

#include <vector>

#include "figures/report_figure.h"

namespace tribolog::paper::drawings {

/// In the paper's order. They show the models that the program computes with and depend on no log;
/// `gear_ratio` (> 0) is printed where the paper prints 100. `ReportFigure::stage` is empty.
std::vector<figures::ReportFigure> paper_drawings(double gear_ratio = 100.0);

}  // namespace tribolog::paper::drawings
