#pragma once
// How far a joint travels after a reversal until its friction has reversed.

#include <optional>

#include "method/gravity/cog_sweep.h"

namespace tribolog::method::hysteresis {

/// Joint travel after a reversal of the sweep within which friction reaches 70 % of the Coulomb
/// torque of the new direction [rad], median over the reversals. Absent if the sweep shows no
/// reversal, no gravity or no Coulomb torque.
/// @param found of that sweep.
std::optional<double> presliding_travel_rad(const motion::Sweep& sweep,
                                            const gravity::CogSweepResult& found,
                                            double gear_ratio);

}  // namespace tribolog::method::hysteresis
