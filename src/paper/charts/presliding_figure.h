#pragma once
// Figure 5: hysteresis of friction under an oscillating force.

#include <vector>

#include "figures/report_figure.h"
#include "simulate/presliding_loops.h"

namespace tribolog::paper::charts {

/// One panel for each loop, friction over displacement, all with the same axis of force; their
/// widths may differ by orders of magnitude, so that each has its own axis of displacement.
/// @param loops at least one.
/// @throw std::invalid_argument if there is none.
figures::ReportFigure presliding_hysteresis_figure(
    const std::vector<simulate::PreslidingLoop>& loops);

}  // namespace tribolog::paper::charts
