#pragma once
// Figure 1: static friction that is discontinuous at rest, eq. (1).

#include "figures/report_figure.h"
#include "friction/stribeck.h"

namespace tribolog::paper {

/// Friction over speed on both sides of rest, the range at rest, and the levels.
ReportFigure static_friction_figure(const StribeckFriction& friction);

}  // namespace tribolog::paper
