#pragma once
// The paper's charts of friction laws, figures 2 to 6 and their scale.

#include <vector>

#include "figures/report_figure.h"
#include "friction/static_laws.h"
#include "simulate/presliding_loops.h"

namespace tribolog::paper::charts {

// Figures 1 and 2: static friction that is discontinuous at rest, eq. (1), and its linear zone,
// eq. (2).

// The law itself is what is drawn solid.

/// Friction over speed on both sides of rest, the range at rest, and the levels.
figures::ReportFigure static_friction_figure(const friction::StribeckFriction& friction);

// Figure 2: static friction made continuous by a linear zone around rest, eq. (2).

/// The whole curve above, the close-up of the linear zone below.
/// @throw std::invalid_argument for a law without Stribeck effect (decay 0): its decay is the scale
/// of the chart.
figures::ReportFigure linear_zone_figure(const friction::ThresholdSpeedFriction& friction);

// Figure 5: hysteresis of friction under an oscillating force.

/// One panel for each loop, friction over displacement, all with the same axis of force; their
/// widths may differ by orders of magnitude, so that each has its own axis of displacement.
/// @param loops at least one.
/// @throw std::invalid_argument if there is none.
figures::ReportFigure presliding_hysteresis_figure(
    const std::vector<simulate::PreslidingLoop>& loops);

}  // namespace tribolog::paper::charts
