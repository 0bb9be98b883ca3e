#pragma once
// Gravity torque from oscillations at several positions of the motor, for mid-lines and loop fit
// alike.
//
// Over a micro-oscillation ripple is a constant, a different one at each position. Where the sweep
// has shown the ripple's periods and there are positions to spare, sines of these periods are
// fitted along with the mean, and only their residuals count as scatter. Where it shows none, and
// six or more positions are spread evenly over a motor turn, harmonics of the motor's angle are
// fitted instead (two fewer orders than half the positions): an even spread averages such ripple
// out, and plain scatter would count it as error. Otherwise the plain mean, with the scatter of the
// positions.

#include <cstddef>
#include <string>
#include <vector>

#include "base/statement.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/ripple_spectrum.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// From this many positions on, their scatter shows the ripple.
inline constexpr std::size_t fewest_positions = 3;

/// Positions that see different ripple: motor angles more than a 24th of a turn apart (ripple of
/// six periods a turn has then gone through a quarter of one), or a quarter of the period of the
/// strongest line where that is shorter.
std::size_t distinct_positions(std::vector<double> motor_angle_rad, const gravity::Ripple& ripple);

/// Of each motor angle the number of its position, ascending: angles of one position lie within an
/// eighth of the period of friction that changes six times a turn.
std::vector<std::size_t> position_numbers(const std::vector<double>& motor_angle_rad);

struct PositionMean {
  statistics::Estimate gravity_Nm;
  /// Degrees of freedom of the positions' scatter. 0: distinct positions are fewer than three; the
  /// interval is that of the recordings, and has yet to be widened by ripple (with_ripple()).
  double freedom{};
  /// Residual of each position, in the order of the angles; empty without degrees of freedom.
  std::vector<double> residuals_Nm;
};

/// Recordings that repeat a position are averaged first: they share its ripple. Fewer than three
/// distinct positions: the wider of the recordings' own intervals and of their scatter.
/// @param gravity_Nm of each recording, at the gravity peak, motor side.
/// @param motor_angle_rad centre of each oscillation.
/// @param scatter what the interval from fewer than three positions is based on.
/// @throw std::invalid_argument if there is none, or the sizes differ.
PositionMean mean_over_positions(const std::vector<statistics::Estimate>& gravity_Nm,
                                 const std::vector<double>& motor_angle_rad,
                                 const gravity::Ripple& ripple, const Statement& scatter);

/// Share of a line's amplitude left in the mean over these motor angles, 0 to 1.
double share_left_in_mean(const gravity::RippleLine& line,
                          const std::vector<double>& motor_angle_rad);

/// What a sweep shows without that of few periods along it, which is friction over the joint's
/// angle, not over the motor's turn.
gravity::CogSweepResult of_motor_turn(gravity::CogSweepResult sweep, double gear_ratio);

}  // namespace tribolog::method::hysteresis
