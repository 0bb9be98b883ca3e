#pragma once
// LuGre fitted to the hysteresis loop: measured torque with the model over it, and what it leaves.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Not one of the paper's. Nothing if no fit converged.
std::optional<ReportFigure> lugre_loop_figure(const Calibration& calibration);

}  // namespace tribolog::figures
