#pragma once
// Gravity torque from oscillations at several positions of the motor.
//
// Over a micro-oscillation ripple is a constant, another one at each position. Where the sweep has
// shown the ripple's periods and there are positions to spare, their sines are fitted along with
// the mean, so that only what they leave counts as scatter. Else the plain mean, with the scatter
// of the positions.

#include <vector>

#include "stages/estimate.h"
#include "stages/ripple_spectrum.h"

namespace tribolog {

struct PositionMean {
  Estimate gravity_Nm;
  double freedom{};  ///< Degrees of freedom of its scatter.
};

/// @param gravity_Nm at each position, motor side, at least three.
/// @param motor_angle_rad centres of the oscillations.
PositionMean mean_over_positions(const std::vector<double>& gravity_Nm,
                                 const std::vector<double>& motor_angle_rad, const Ripple& ripple);

/// Share of a line's amplitude left in the mean over these motor angles, 0 to 1.
double share_left_in_mean(const RippleLine& line, const std::vector<double>& motor_angle_rad);

}  // namespace tribolog
