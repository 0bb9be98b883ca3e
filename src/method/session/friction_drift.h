#pragma once
// Does friction change over the session, as in a gear that warms up?
//
//   friction = law(speed) (1 + change g(time))
//   law = a + b exp(-(w/ws)^d) + c w^p + e log w + f log^2 w
//
// over all levels of friction that were recorded: of each pair of strokes of equal speed, and of
// each oscillation's first and second half, whose law is one number for all of the same amplitude
// and frequency. g is 0 at the session's begin and 1 at its end: a straight line, or an exponential
// of one of several time constants. The law's ws, d and p are searched over a grid, as the time
// constant is; what all combinations that describe the levels about equally well say of the change
// is its interval. The logarithms stand for what no law of friction describes: in runs of ascending
// speed time is a smooth function of the speed, and must not make up for a law that does not fit.
// What shows a change is then a speed or an oscillation that comes again, and the sweep against the
// runs at nearly its speed. Where speeds are too few for a law, only repeats of a speed count.

#include <cstddef>
#include <vector>

namespace tribolog::method::session {

/// Friction at one time. Motor side.
struct FrictionLevel {
  double speed_rad_s{};  ///< Magnitude; unused where `family` is set.
  int family{-1};        ///< Oscillations alike in amplitude and frequency; -1: strokes.
  double friction_Nm{};
  double standard_error_Nm{};
  std::vector<double> session_share;  ///< Times over which it is the mean.
};

/// How friction changed: 1 + change * progress(share of the session).
struct FrictionDrift {
  bool examined{};
  bool found{};     ///< Certain, and large enough to matter.
  double change{};  ///< From begin to end, as a share of the friction at the begin.
  double low{};     ///< 95 %.
  double high{};
  double time_constant{};  ///< As a share of the session; 0: a straight line.
  double chance{1};        ///< Of as large an improvement without any change.
  std::size_t levels{};
  /// Time constants that describe the levels about equally well, and the change with each.
  std::vector<double> other_time_constants;
  std::vector<double> other_changes;
};

/// 0 at the begin, 1 at the end of the session. @param time_constant 0: a straight line.
double progress(double session_share, double time_constant);

FrictionDrift fit_friction_drift(const std::vector<FrictionLevel>& levels);

}  // namespace tribolog::method::session
