#pragma once
// One oscillation cut for display: first strokes, the cycles shown over time, and its axes.

#include <optional>
#include <vector>

#include "calibration/calibration.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::figures {

/// The first oscillation of a calibration. Refers to it; must not outlive it.
struct LoopView {
  const LoopTrace* trace{};
  bool modelled{};  ///< The bristle is the fitted model's, not recorded.
  const std::vector<double>* model_torque_Nm{};  ///< On the trace's samples; null: no fit.
  double centre_rad{};                           ///< What x counts from in the loops.
  double cycles{};                               ///< Recorded; 0: not known.
  double first_strokes_end_s{};                  ///< Time up to which the first strokes go.
  double shown_end_s{};                          ///< Time up to which the panels over time go.
  AxisScale angle;                               ///< x of the loops, offset by the centre.

  [[nodiscard]] std::vector<double> until(double end_s, const std::vector<double>& signal) const;
  /// Time as shown: from the first sample on.
  [[nodiscard]] AxisScale time() const;
};

/// Nothing if there is no trace with at least one sample.
std::optional<LoopView> loop_view(const Calibration& calibration);

/// The reading points A to F on a panel.
enum class LoopSignal { torque, deflection, deflection_rate };

/// That signal of a point, SI.
double reading(const LoopPoint& point, LoopSignal signal);

void add_loop_points(render::Panel& panel, const std::vector<LoopPoint>& points, LoopSignal signal,
                     bool over_time, const LoopView& view, const AxisScale& y);

/// A vertical line at the gravity peak, if the loop passes it or comes close.
/// @return whether it does.
bool add_gravity_peak(render::Panel& panel, const Calibration& calibration, const LoopView& view);

}  // namespace tribolog::figures
