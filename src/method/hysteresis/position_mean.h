#pragma once
// Gravity torque from oscillations at several positions of the motor: of the mid-lines and of the
// loop fit alike.
//
// Over a micro-oscillation ripple is a constant, another one at each position. Where the sweep has
// shown the ripple's periods and there are positions to spare, their sines are fitted along with
// the mean, so that only what they leave counts as scatter. Where it shows none, and six positions
// or more are spread evenly over a motor turn, harmonics of the motor's angle are fitted instead
// (two fewer orders than half the positions): an even spread averages such ripple out, and plain
// scatter would take it for an error. Else the plain mean, with the scatter of the positions.

#include <cstddef>
#include <string>
#include <vector>

#include "base/statement.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/ripple_spectrum.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

/// From this many positions on their scatter tells of the ripple.
inline constexpr std::size_t fewest_positions = 3;

/// Positions that see different ripple: motor angles more than a 24th of a turn apart (ripple of
/// six periods a turn has then gone through a quarter of one), or a quarter of the period of the
/// strongest line where that is shorter.
std::size_t distinct_positions(std::vector<double> motor_angle_rad, const gravity::Ripple& ripple);

struct PositionMean {
  statistics::Estimate gravity_Nm;
  /// Degrees of freedom of the positions' scatter. 0: distinct positions are fewer than three; the
  /// interval is that of the recordings, and ripple has still to be laid on it (with_ripple()).
  double freedom{};
  /// What each position leaves, in the order of the angles; empty without degrees of freedom.
  std::vector<double> residuals_Nm;
};

/// Recordings that repeat a position are averaged first: they share its ripple. Fewer than three
/// distinct positions: the wider of the recordings' own intervals and of their scatter.
/// @param gravity_Nm of each recording, at the gravity peak, motor side.
/// @param motor_angle_rad centres of the oscillations, one of each.
/// @param scatter what the interval of fewer than three positions comes from.
/// @throw std::invalid_argument if there is none, or the sizes differ.
PositionMean mean_over_positions(const std::vector<statistics::Estimate>& gravity_Nm,
                                 const std::vector<double>& motor_angle_rad,
                                 const gravity::Ripple& ripple, const Statement& scatter);

/// Share of a line's amplitude left in the mean over these motor angles, 0 to 1.
double share_left_in_mean(const gravity::RippleLine& line,
                          const std::vector<double>& motor_angle_rad);

/// Half width that 95 % of means over so many motor angles stay within, of what changes with the
/// angle: each line at a phase of its own, with the share that its mean leaves; the rest as it is,
/// for nobody knows how far it reaches [N·m].
double half_width_left_in_mean(const gravity::Ripple& of_angle,
                               const std::vector<double>& motor_angle_rad);

/// The same of the friction that a sweep shows, as a share of its friction. 0 where it shows no
/// change of friction with the angle.
double share_of_friction_left(const gravity::CogSweepResult& sweep,
                              const std::vector<double>& motor_angle_rad);

}  // namespace tribolog::method::hysteresis
