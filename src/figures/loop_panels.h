#pragma once
// The micro-oscillation cut for display, and its signals over angle and over time.

#include <optional>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "figures/report_figure.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// The first oscillation of a calibration. Refers to it; must not outlive it.
struct LoopView {
  const method::hysteresis::LoopTrace* trace{};
  bool modelled{};  ///< The bristle is the fitted model's, not recorded.
  const std::vector<double>* model_torque_Nm{};  ///< On the trace's samples; null: no fit.
  double centre_rad{};                           ///< What x counts from in the loops.
  double cycles{};                               ///< Recorded; 0: not known.
  double first_strokes_end_s{};                  ///< Time up to which the first strokes go.
  double shown_end_s{};                          ///< Time up to which the panels over time go.
  wording::AxisScale angle;                      ///< x of the loops, offset by the centre.

  [[nodiscard]] std::vector<double> until(double end_s, const std::vector<double>& signal) const;
  /// Time as shown: from the first sample on.
  [[nodiscard]] wording::AxisScale time() const;
};

/// Nothing if there is no trace with at least one sample.
std::optional<LoopView> loop_view(const calibration::Calibration& calibration);

/// The reading points A to F on a panel.
enum class LoopSignal { torque, deflection, deflection_rate };

/// That signal of a point, SI.
double reading(const method::hysteresis::LoopPoint& point, LoopSignal signal);

void add_loop_points(render::figure::Panel& panel,
                     const std::vector<method::hysteresis::LoopPoint>& points, LoopSignal signal,
                     bool over_time, const LoopView& view, const wording::AxisScale& y);

/// A vertical line at the gravity peak, if the loop passes it or comes close.
/// @return whether it does.
bool add_gravity_peak(render::figure::Panel& panel, const calibration::Calibration& calibration,
                      const LoopView& view);

// A signal of the micro-oscillation over angle and over time, in two panels.

/// Colour of all samples behind the first strokes.
inline constexpr render::figure::Colour cloud{190, 190, 190};
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
  wording::AxisScale scale;
};

/// The signal over angle (above) and over time (below), with the points A to F on both.
ReportFigure two_panels(const calibration::Calibration& calibration, const LoopView& view,
                        const LoopCurves& curves);

}  // namespace tribolog::figures
