#pragma once
// Figures of the viscous curve's parameters: its models, its directions, its load.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Above, the curve with the model chosen and its competitors; below, each model's error on its
/// own data and at speeds held out, over its number of parameters. Absent where none was chosen.
std::optional<ReportFigure> curve_model_figure(const calibration::Calibration& calibration);

// Each direction's friction by itself, with its straight line.

/// With the stated gravity where there is one, else with the recommended. Absent where neither
/// direction has a line, and for a sweep, whose directions figure 21 shows.
std::optional<ReportFigure> direction_lines_figure(const calibration::Calibration& calibration);

// Friction against the gravity torque that loads the joint.

/// Above, friction (less its viscous part, where the speed changes) over the load with the fitted
/// line; below, friction over the joint angle with the fit. Absent where it was not examined.
std::optional<ReportFigure> load_dependence_figure(const calibration::Calibration& calibration);

}  // namespace tribolog::figures
