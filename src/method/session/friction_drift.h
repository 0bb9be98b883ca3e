#pragma once
// Does friction change over the session, as in a gear that warms up?
//
//   friction = law(speed) (1 + change g(time))
//   law = a + b exp(-(w/ws)^d) + c w^p + e log w + f log^2 w
//
// over all recorded levels of friction: of each pair of strokes of equal speed, and of each
// oscillation's first and second half, whose law is one number for all of the same amplitude and
// frequency. g is 0 at the session's start and 1 at its end: a straight line, or an exponential
// with one of several time constants. The law's ws, d and p are searched over a grid, as is the
// time constant; the interval of the change covers all combinations that describe the levels about
// equally well. The logarithms represent what no friction law describes: in runs of ascending speed
// time is a smooth function of speed, and must not compensate for a law that does not fit. A change
// then shows in a speed or an oscillation that is repeated, and in the sweep compared with the runs
// at nearly its speed. Where there are too few speeds for a law, only repeats of a speed count.

#include <cstddef>
#include <vector>

namespace tribolog::method::session {

/// Friction at one time. Motor side.
struct FrictionLevel {
  double speed_rad_s{};  ///< Magnitude; unused where `family` is set.
  int family{-1};        ///< Oscillations alike in amplitude and frequency; -1: strokes.
  double friction_Nm{};
  double standard_error_Nm{};
  std::vector<double> session_share;  ///< Times of which it is the mean.
};

/// How friction changed: 1 + change * progress(share of the session).
struct FrictionDrift {
  bool examined{};
  bool found{};     ///< Certain, and large enough to matter.
  double change{};  ///< From start to end, as a share of the friction at the start.
  double low{};     ///< 95 %.
  double high{};
  double time_constant{};  ///< As a share of the session; 0: a straight line.
  double chance{1};        ///< Probability of as large an improvement without any change.
  std::size_t levels{};
  /// Time constants that describe the levels about equally well, and the change with each.
  std::vector<double> other_time_constants;
  std::vector<double> other_changes;
};

/// 0 at the start, 1 at the end of the session. @param time_constant 0: a straight line.
double progress(double session_share, double time_constant);

FrictionDrift fit_friction_drift(const std::vector<FrictionLevel>& levels);

}  // namespace tribolog::method::session
