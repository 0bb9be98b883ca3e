#pragma once
// What the noise of a recorded angle does to a fit along the motion traced through it.
//
// The traced motion is taken for the truth, recorded again with the noise that was found (its steps
// at another phase, or other white noise), traced anew, and the fit takes one step from its
// solution. Steps of several such recordings show the error that no scatter of the torque shows:
// motion that is smoothed too much at every turn is wrong in the same way in all half loops.
//
// Of long recordings a part shows it: the shift by the noise of the part, over the root of how many
// parts there are. The deflection at the start, which the first strokes alone tell, keeps its own.

#include <vector>

#include <Eigen/Core>

#include "method/hysteresis/lugre_input.h"
#include "method/hysteresis/lugre_ladder.h"

namespace tribolog {

/// Columns whose products with themselves add up to the parameters' covariance by that noise, in
/// the order of the climb's columns; none where no motion was traced.
Eigen::MatrixXd shifts_by_motion_noise(const std::vector<LuGreInput>& loops,
                                       const LuGreClimb& climb, double gear_ratio,
                                       double q_peak_rad);

}  // namespace tribolog
