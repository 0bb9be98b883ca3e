#pragma once
// Coulomb torque, Stribeck velocity and viscous coefficient as the calibration states them: one
// value each, wherever they are printed.
//
// From the sliding law of the runs; without runs, from loops that slide far enough to show Coulomb
// torque; else from the straight line through few runs or the pairs of a sweep; and failing these,
// from the sweep's own fit.

#include "calibration/calibration.h"

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

}  // namespace tribolog::calibration
