#pragma once
// The level to which friction tends while a break-away ramp moves the joint: one form, friction
// over travel, Tf(x) = level - fall exp(-x / way) (break_away.h).

#include <optional>
#include <vector>

namespace tribolog::method::hysteresis {

/// The level to which friction tends while the joint rests [N·m]; absent where it does not bend
/// over, or shows too few distinct angles.
/// @param travel from rest up to break-away [rad]; its length is that of `friction`.
/// @param friction driving torque less gravity in the ramp's direction [N·m].
/// @param reading friction at break-away [N·m].
std::optional<double> level_at_rest(const std::vector<double>& travel,
                                    const std::vector<double>& friction, double reading);

/// The level at which friction stays while the joint is moved on at an even speed, as by a slow
/// ramp of the position [N·m]: it slides, and never runs away. Absent where friction still rises,
/// falls with the speed, or changes with the angle.
/// @param travel from rest [rad]; its length is that of `friction` [N·m], as above.
std::optional<double> level_of_even_slide(const std::vector<double>& travel,
                                          const std::vector<double>& friction);

}  // namespace tribolog::method::hysteresis
