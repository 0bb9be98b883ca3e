#pragma once
// How much later the torque is logged than the angle, from the starts and stops of sweeps and runs.
//
// Where the joint speeds up and slows down the torque follows the acceleration; one that is late
// follows the acceleration of a moment before:
//
//   T(t) = J a(t - lag) + Tf(|v|) sgn v + b cos q + c sin q + offset
//
// a(t - lag) = a - lag a' + lag^2/2 a'' - ...: the ratio of two coefficients of a linear
// regression, repeated with the torque moved by what was found until nothing is left of it. Tf is a
// polygon over the speed, so that no friction law is asked for. A first-order filter of the torque
// looks the same but for the last term, which is free.
//
// It fails where accelerations are too short for the sampling, or too small against the noise; the
// interval then says so, or nothing is found.

#include <optional>
#include <vector>

#include "joint/recording.h"
#include "statistics/estimate.h"

namespace tribolog::method::motion {

struct TorqueLag {
  /// [s]; > 0: the torque is late against the angle. Absent: the recordings do not show it.
  std::optional<statistics::Estimate> lag_s;
  /// Of all that turns with the joint, reflected to the motor [kg·m²].
  std::optional<statistics::Estimate> inertia_kgm2;
  /// By starts alone or stops alone less by both, whichever is farther, as a share of it.
  double inertia_apart{};
  std::size_t transients{};  ///< Starts and stops that were looked at.
  Statement why_not;         ///< Empty where lag_s is there.

  /// The interval leaves out zero: it is taken off the oscillations' torque.
  [[nodiscard]] bool is_clear() const { return lag_s && (lag_s->low > 0 || lag_s->high < 0); }
};

/// The recording with its torque as it was so much later: beside the angle that it belongs to.
/// Samples at the end, whose torque was not recorded any more, are left out.
joint::Recording aligned(const joint::Recording& recording, double lag_s);

/// @param recordings sweeps and runs, of any number.
TorqueLag find_torque_lag(const std::vector<const joint::Recording*>& recordings,
                          double gear_ratio);

}  // namespace tribolog::method::motion
