#pragma once
// All constant-speed strokes of a session, in pairs of equal speed and opposite direction over the
// same angles, each cut into cells of the angle. At equal angle and speed half the difference of a
// pair is friction, its mean is all that does not change sign with the motion.

#include <cstddef>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "method/gravity/ripple_spectrum.h"
#include "method/session/session_times.h"

namespace tribolog::method::session {

/// One direction over one cell of the angle: means over its samples. Motor side.
struct StrokeCell {
  std::size_t pair{};   ///< Index of its StrokePair.
  std::size_t block{};  ///< Cells whose errors may be correlated: in a sweep those at the same
                        ///< angle, in a run all.
  double direction{};   ///< +1: joint angle rising.
  double q_rad{};
  double torque_Nm{};
  double session_share{};  ///< Time, as a share of the session.
  double samples{};
};

struct StrokePair {
  std::string recording;  ///< Of the earlier stroke.
  bool of_sweep{};
  double speed_rad_s{};  ///< Motor side, magnitude.
  double lowest_rad{};   ///< Common angles.
  double highest_rad{};
  double friction_Nm{};  ///< Half the difference of the two directions, mean over the cells.
  /// Times of the two strokes, as shares of the session: start and end of each.
  double session_share[4]{};
};

struct StrokePairs {
  std::vector<StrokePair> pairs;  ///< In the order of time.
  std::vector<StrokeCell> cells;  ///< Ordered by pair, then angle; falling before rising.
  double widest_rad{};            ///< Largest common travel of a pair.
};

/// @param recordings of the whole dataset; sweeps of varying speed take no part.
/// @param ripple known from the rough sweep, subtracted from the torques.
StrokePairs find_stroke_pairs(const std::vector<joint::Recording>& recordings,
                              const SessionTimes& times, double gear_ratio,
                              const gravity::Ripple& ripple);

}  // namespace tribolog::method::session
