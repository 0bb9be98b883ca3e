#pragma once
// Coulomb torque, Stribeck velocity, viscous coefficient and inertia as the calibration states
// them: one value each, wherever they are printed or used.
//
// The curve: from the sliding law of the runs; without runs, from loops that slide far enough to
// show Coulomb torque; else from the straight line through few runs or the pairs of a sweep; and
// failing these, from the sweep's own fit.

#include <optional>

#include "calibration/calibration.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

enum class HeadlineSource { sliding_law, loops, line, sweep, none };

/// Motor side.
struct CurveHeadline {
  HeadlineSource source{HeadlineSource::none};
  method::viscous::SlidingQuantity coulomb_Nm;
  method::viscous::SlidingQuantity stribeck_speed_rad_s;
  method::viscous::SlidingQuantity viscous_Nms_rad;
};

CurveHeadline curve_headline(const Calibration& calibration);

/// Inertia shows best where the whole joint accelerates: in starts and stops or in a sweep of
/// varying speed, whichever interval is narrower. Slow small loops hardly show it.
enum class InertiaSource { starts, sweep, loops, none };

/// Reflected inertia at the motor [kg·m²].
struct InertiaHeadline {
  InertiaSource source{InertiaSource::none};
  std::optional<statistics::Estimate> kgm2;  ///< Absent without a source.
};

InertiaHeadline inertia_headline(const Calibration& calibration);

}  // namespace tribolog::calibration
