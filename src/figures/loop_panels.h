#pragma once
// A signal of the micro-oscillation over angle and over time, in two panels.

#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "figures/loop_view.h"
#include "figures/report_figure.h"

namespace tribolog::figures {

/// Colour of all samples behind the first strokes.
inline constexpr render::Colour cloud{190, 190, 190};
/// Wider than the strokes: where every cycle is the same, it stays visible on both sides of them.
inline constexpr double cloud_px = 8.0;
inline constexpr double strokes_px = 3.0;

/// A signal of the loop and how it is shown.
struct LoopCurves {
  LoopSignal signal;
  std::string title;                   ///< "driving torque T"
  const std::vector<double>* all;      ///< Every sample; null: nothing to put behind the strokes.
  const std::vector<double>* strokes;  ///< What the first strokes are drawn from.
  std::string all_label;
  std::string strokes_label;
  AxisScale scale;
};

/// The signal over angle (above) and over time (below), with the points A to F on both.
ReportFigure two_panels(const Calibration& calibration, const LoopView& view,
                        const LoopCurves& curves);

}  // namespace tribolog::figures
