#pragma once
// Gravity torque from oscillations at several positions.
//
// Torque ripple is a constant over a micro-oscillation: it shifts what one position shows, and no
// repetition there averages it out. Several positions do, and their scatter is the measure of it.

#include <cstddef>
#include <string>
#include <vector>

#include "stages/estimate.h"

namespace tribolog {

/// From this many positions on their scatter tells of the ripple.
inline constexpr std::size_t fewest_positions = 3;

/// Positions that see different ripple: joint angles whose motor angles are more than a 24th of a
/// turn apart (ripple of six periods a turn has then gone through a quarter of one).
std::size_t distinct_positions(std::vector<double> centres_rad, double gear_ratio);

/// One estimate from one of each recording, each already at the gravity peak.
///
/// One stays as it is; of two, the wider of their scatter and their own intervals; from three on
/// the scatter makes the interval. From six positions on that are spread over a motor turn, ripple
/// is fitted as harmonics of the motor's angle (two fewer orders than half the positions), and only
/// what scatters about that counts: an even spread averages such ripple out, and plain scatter
/// would take it for an error. Ripple with as many periods a turn as there are positions stays
/// unseen.
/// @param centres_rad joint angles of the recordings, as many as estimates.
/// @param from_one_source what scatters within a recording: "cycles".
/// @throw std::invalid_argument if there is none, or the sizes differ.
Estimate combined_over_recordings(const std::vector<Estimate>& gravity_Nm,
                                  const std::vector<double>& centres_rad, double gear_ratio,
                                  const std::string& from_one_source);

/// A torque read at one position, with the ripple that the sweep shows laid on its interval.
Estimate with_ripple(Estimate torque, double ripple_Nm);

}  // namespace tribolog
