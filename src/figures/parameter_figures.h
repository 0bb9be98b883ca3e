#pragma once
// The figure of the viscous curve's models.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Above, the curve with the model chosen and its competitors; below, each model's error on its
/// own data and at speeds held out, over its number of parameters. Absent where none was chosen.
std::optional<ReportFigure> curve_model_figure(const calibration::Calibration& calibration);

}  // namespace tribolog::figures
