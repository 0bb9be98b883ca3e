#pragma once
// Where a prescribed motion turns round.

#include "friction/speed_step.h"
#include "simulate/motion.h"

namespace tribolog {

/// Is one of the three speeds forward and another one backward?
inline bool reverses(double w0, double wm, double w1) {
  return (w0 > 0 || wm > 0 || w1 > 0) && (w0 < 0 || wm < 0 || w1 < 0);
}

inline bool reverses(const SpeedStep& step) {
  return reverses(step.start_rad_s, step.middle_rad_s, step.end_rad_s);
}

/// Time [s] in [a, b] at which the speed changes sign, by bisection to the last bit; the speed is
/// asked for only where its sign is in doubt.
/// @param negative_first whether the motion is backward before. It is the caller's to say: where
/// the reversal is at `a` itself, the speed there may have either sign by rounding.
double reversal_time(const Motion& motion, double a_s, double b_s, bool negative_first);

}  // namespace tribolog
