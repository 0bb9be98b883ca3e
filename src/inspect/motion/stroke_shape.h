#pragma once
// Whether a stroke runs at constant speed, and how fast.
//
// The speed is taken from the angle: the mean slope between two marks of the travel. The speed that
// a controller logs is not trusted: some are two-point differences, which at low speed are steps of
// the encoder.

#include "inspect/motion/angle_trace.h"
#include "inspect/motion/strokes.h"

namespace tribolog {

struct StrokeShape {
  double speed_rad_s{};  ///< Mean between 30 and 70 % of the travel, >= 0.
  /// As fast near its ends as in the middle: between 10 and 25 %, and 75 and 90 % of its travel, at
  /// least 0.87 of that; a sine is at 0.75 there, a speed that rises and falls linearly at 0.61. Or
  /// so at one end alone, and even in the middle: a run that creeps at first, or at last.
  bool is_steady{};
};

StrokeShape shape_of(const AngleTrace& trace, const AngleStroke& stroke);

}  // namespace tribolog
