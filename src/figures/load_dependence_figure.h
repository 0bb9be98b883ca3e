#pragma once
// Friction against the gravity torque that loads the joint.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Above, friction (less its viscous part, where the speed changes) over the load with the fitted
/// line; below, friction over the joint angle with the fit. Absent where it was not examined.
std::optional<ReportFigure> load_dependence_figure(const Calibration& calibration);

}  // namespace tribolog::figures
