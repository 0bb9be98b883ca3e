#pragma once
// Figures 15, 16 and 17: the micro-oscillation as T, z and dz/dt over angle and over time.
//
// A log of ten noisy cycles is a grey cloud. On it stands, in colour and with arrows, the way of
// the first strokes from rest: measured where the bristle was recorded, else that of the fitted
// model. The points A to F are those the calibration read.

#include <optional>

#include "calibration/calibration.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Figure 15: T(q) with the mid-line, and T(t). Absent without a loop.
std::optional<ReportFigure> torque_loop_figure(const calibration::Calibration& calibration);

/// Figure 16: z(q) and z(t). Absent if no bristle state is to be had.
std::optional<ReportFigure> bristle_loop_figure(const calibration::Calibration& calibration);

/// Figure 17: dz/dt(q) and dz/dt(t). Absent if no bristle state is to be had.
std::optional<ReportFigure> bristle_rate_loop_figure(const calibration::Calibration& calibration);

}  // namespace tribolog::figures
