#pragma once
// The motion that a model of the loop is driven along: harmonics of a joint that is moved along a
// sine, a spline through the angle of any other.

#include <optional>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/motion/oscillation_motion.h"
#include "method/motion/traced_motion.h"

namespace tribolog::method::motion {

struct FollowedMotion {
  std::optional<OscillationMotion> harmonic;  ///< Where the angle swings with a period.
  /// The harmonics are those of what comes later than this after the first sample, where the first
  /// cycles, in which a drive starts the motion, differ [s].
  double from_s{};
  /// Where harmonics leave more of the angle than its noise, in the later cycles too: a joint that
  /// is driven by a torque creeps and drifts.
  std::optional<TracedMotion> traced;
  Statement why_not_traced;  ///< Why there is no spline; empty if there is one or none was wanted.
  bool is_followed{};        ///< By one of the two.
};

/// @param encoder_step_rad of the angle, joint side; 0: continuous, or hidden by the print.
FollowedMotion follow_the_angle(const joint::Recording& recording, double encoder_step_rad);

}  // namespace tribolog::method::motion
