#pragma once
// Coulomb torque, Stribeck velocity, viscous coefficient and inertia as the calibration states
// them: one value each, wherever they are printed or used.
//
// Coulomb torque and viscous coefficient: of the one model of sweeps, runs and points. The rest of
// the curve, and all of it where there is no such model: from the sliding law of the runs; without
// runs, from loops that slide far enough to show Coulomb torque; else from the straight line
// through few runs or the pairs of a sweep; and failing these, from the sweep's own fit.

#include <optional>

#include "calibration/calibration.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

enum class HeadlineSource { model, sliding_law, loops, line, sweep, none };

/// Motor side.
struct CurveHeadline {
  HeadlineSource source{HeadlineSource::none};
  method::viscous::SlidingQuantity coulomb_Nm;
  method::viscous::SlidingQuantity stribeck_speed_rad_s;
  method::viscous::SlidingQuantity viscous_Nms_rad;
  /// The curve follows eq. (6), which has neither Coulomb torque nor one viscous coefficient.
  bool is_of_waiboer{};
};

CurveHeadline curve_headline(const Calibration& calibration);

/// Inertia shows best where the whole joint accelerates: in sweeps and runs, which the one model
/// reads; slow small loops hardly show it. Whichever interval is narrower. Without a model: a sweep
/// of varying speed, and without one the loops.
enum class InertiaSource { model, sweep, loops, none };

/// Reflected inertia at the motor [kg·m²].
struct InertiaHeadline {
  InertiaSource source{InertiaSource::none};
  std::optional<statistics::Estimate> kgm2;  ///< Absent without a source.
};

InertiaHeadline inertia_headline(const Calibration& calibration);

}  // namespace tribolog::calibration
