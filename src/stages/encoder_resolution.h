#pragma once
// Whether the angle was recorded finely enough to see pre-sliding.

#include <optional>
#include <vector>

#include "stages/cog_sweep.h"

namespace tribolog {

/// The step in which the angles are quantised [rad], or 0 if they look continuous: the smallest
/// difference of neighbours, if nearly all differences are whole multiples of it.
double encoder_step_rad(const std::vector<double>& q_rad);

/// Joint travel after a reversal of the sweep within which friction turns over to 70 % of the
/// Coulomb torque of the other direction [rad], median over the reversals. Absent if the sweep
/// shows no reversal, no gravity or no Coulomb torque.
std::optional<double> presliding_travel_rad(const CogSweepResult& sweep, double gear_ratio);

/// A loop needs this many encoder steps across its pre-sliding range to be read.
inline constexpr double fewest_steps_in_presliding = 50;

}  // namespace tribolog
