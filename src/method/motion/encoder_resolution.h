#pragma once
// Whether the angle was recorded finely enough to resolve pre-sliding.

#include <vector>

namespace tribolog::method::motion {

/// The step in which numbers are quantised, in their unit, or 0 if they look continuous: the
/// smallest difference of neighbours, if nearly all differences are whole multiples of it.
double common_step(const std::vector<double>& values);

/// The step of a log's angles.
struct AngleStep {
  double step_rad{};       ///< 0: the angles look continuous.
  bool is_of_the_print{};  ///< It is that of the printed decimals: the log resolves nothing finer,
                           ///< and the encoder's own step may be larger.
};

/// The common step of the angles; where there is none above it, the coarsest power of ten, in rad
/// or in degrees, at the joint or at the motor, that nearly all different angles are whole
/// multiples of. Down to 1e-6 of the unit: finer prints count as continuous.
/// @param gear_ratio motor angle per joint angle, > 0: logs of the motor's angle are printed there.
AngleStep angle_step(const std::vector<double>& q_rad, double gear_ratio);

/// A loop needs this many encoder steps across its pre-sliding range to be read.
inline constexpr double fewest_steps_in_presliding = 50;

}  // namespace tribolog::method::motion
