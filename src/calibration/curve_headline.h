#pragma once
// Coulomb torque, Stribeck velocity and viscous coefficient as the calibration states them: one
// value each, wherever they are printed.
//
// From the sliding law of the runs; where there are no runs, from the straight line through the
// pairs of a sweep; where there are none of these either, from the sweep's own fit.

#include "calibration/calibration.h"

namespace tribolog::calibration {

enum class HeadlineSource { sliding_law, line, sweep, none };

/// Motor side.
struct CurveHeadline {
  HeadlineSource source{HeadlineSource::none};
  method::viscous::SlidingQuantity coulomb_Nm;
  method::viscous::SlidingQuantity stribeck_speed_rad_s;
  method::viscous::SlidingQuantity viscous_Nms_rad;
};

CurveHeadline curve_headline(const Calibration& calibration);

}  // namespace tribolog::calibration
