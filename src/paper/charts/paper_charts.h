#pragma once
// The paper's figures that are charts of friction laws: 1, 2 and 5.

#include <vector>

#include "figures/report_figure.h"

namespace tribolog::paper {

/// In the paper's order: the static laws at the scale of the paper's joint, and the loops of figure
/// 5 with Table 1 as meant. They depend on no log; `ReportFigure::stage` is empty. Computing figure
/// 5 takes about half a second.
/// @throw std::runtime_error if the solver gives up.
std::vector<ReportFigure> paper_charts();

}  // namespace tribolog::paper
