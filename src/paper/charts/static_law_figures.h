#pragma once
// Figures 1 and 2: static friction that is discontinuous at rest, eq. (1), and its linear zone,
// eq. (2).

#include "figures/report_figure.h"
#include "friction/stribeck.h"
#include "friction/threshold_speed.h"

namespace tribolog::paper::charts {

// The law itself is what is drawn solid.

/// Friction over speed on both sides of rest, the range at rest, and the levels.
figures::ReportFigure static_friction_figure(const friction::StribeckFriction& friction);

// Figure 2: static friction made continuous by a linear zone around rest, eq. (2).

/// The whole curve above, the close-up of the linear zone below.
/// @throw std::invalid_argument for a law without Stribeck effect (decay 0): its decay is the scale
/// of the chart.
figures::ReportFigure linear_zone_figure(const friction::ThresholdSpeedFriction& friction);

}  // namespace tribolog::paper::charts
