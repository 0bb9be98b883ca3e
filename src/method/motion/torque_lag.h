#pragma once
// How much later the torque is logged than the angle, from the starts and stops of sweeps and runs.
//
// Where the joint speeds up and slows down the torque follows the acceleration; a late torque
// follows an earlier acceleration:
//
//   T(t) = J a(t - lag) + Tf(|v|) sgn v + b cos q + c sin q + offset
//
// a(t - lag) = a - lag a' + lag^2/2 a'' - ...: the lag is the ratio of two coefficients of a linear
// regression, repeated with the torque shifted by the lag found until none is left. Tf is a polygon
// over the speed: no friction law is assumed. Torque, gravity and friction are smoothed over the
// same samples as the angle's derivatives are, so that smoothing bends no coefficient. A
// first-order filter of the torque looks the same except for the last term, which is free. Where a
// lag is clear, a delay, a filter, a moving mean and an elastic gear compete (lag_rivals.h), and
// the lag is that of the winner; without one it is a delay's, its interval wide enough for a
// filter's.
//
// It fails where accelerations are too short for the sampling, or too small relative to the noise;
// the interval then shows it, or nothing is found.

#include <optional>
#include <vector>

#include "joint/recording.h"
#include "method/motion/lag_rivals.h"
#include "method/motion/torque_rounding.h"
#include "statistics/estimate.h"

namespace tribolog::method::motion {

struct TorqueLag {
  /// [s]; > 0: the torque lags behind the angle. A delay's, a filter's time constant, or
  /// half a mean's window. Absent: the recordings do not show it.
  std::optional<statistics::Estimate> lag_s;
  /// Absent: no lag and no elasticity is clear, or none of the rivals wins.
  std::optional<LagShape> shape;
  std::vector<LagRival> rivals;  ///< That competed.
  /// Time constant of the first-order filter that rounds the torque as much as the winner does, or
  /// may where none wins; 0: it is a delay, or nothing is clear [s].
  double rounds_as_filter_s{};
  /// Reflected inertia at the motor of all that turns with the joint [kg·m²].
  std::optional<statistics::Estimate> inertia_kgm2;
  /// Relative difference, beyond its noise, of the inertia from starts alone or stops alone,
  /// whichever is larger, to that from both. Part of the interval.
  double inertia_apart{};
  /// The lag over the time that a start takes. A delay leaves the inertia as it is; a filter that
  /// is not much faster than the starts takes from it, unless it is known as one.
  double lag_over_transients{};
  /// Late in the recordings against early in them [s]. Absent: none is there beyond doubt.
  std::optional<statistics::Estimate> change_s;
  std::size_t transients{};  ///< Number of starts and stops used.
  /// There are starts and stops enough, and still they do not show the inertia.
  bool hides_inertia{};
  Statement why_not;  ///< Empty where lag_s is there.

  /// @return nullptr: it did not compete, or did not converge
  [[nodiscard]] const LagRival* rival(LagShape of) const;
  /// That of the torque; where none of the shapes wins, half of what it may be.
  [[nodiscard]] TorqueRounding rounding() const;
  /// Time constant of the first-order filter that rounds by as much as rounding() may be off; 0:
  /// none [s].
  [[nodiscard]] double unknown_rounding_s() const;
  /// The interval excludes zero: the lag is then removed from the oscillations' torque.
  [[nodiscard]] bool is_clear() const { return lag_s && (lag_s->low > 0 || lag_s->high < 0); }
};

/// The recording with its torque advanced by the lag, aligned with the angle that it belongs to.
/// Samples at the end, whose torque was no longer recorded, are left out.
joint::Recording aligned(const joint::Recording& recording, double lag_s);

/// @param recordings sweeps and runs, of any number.
TorqueLag find_torque_lag(const std::vector<const joint::Recording*>& recordings,
                          double gear_ratio);

}  // namespace tribolog::method::motion
