#pragma once
// The ladder of friction models: their curves on the measured one, and their errors.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Above, the curve with the model chosen and its competitors; below, each model's error on its
/// own data and at speeds held out, over its number of parameters. Absent where none was chosen.
std::optional<ReportFigure> curve_model_figure(const Calibration& calibration);

}  // namespace tribolog::figures
