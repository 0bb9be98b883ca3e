#pragma once
// Coulomb torque, Stribeck velocity, viscous coefficient and inertia as the calibration states
// them: one value each, wherever they are printed or used.
//
// Of the one model of sweeps, runs and points; where there is none, from loops that slide far
// enough to show Coulomb torque; and failing these, from the sweep's own fit.

#include <optional>

#include "calibration/calibration.h"
#include "statistics/estimate.h"

namespace tribolog::calibration {

enum class HeadlineSource { model, loops, sweep, none };

/// Motor side. What is not certain states why.
struct HeadlineQuantity {
  std::optional<statistics::Estimate> estimate;
  Statement why_not;  ///< Why there is none; empty: there is one.
};

/// Motor side.
struct CurveHeadline {
  HeadlineSource source{HeadlineSource::none};
  HeadlineQuantity coulomb_Nm;
  HeadlineQuantity stribeck_speed_rad_s;
  HeadlineQuantity viscous_Nms_rad;
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
