#pragma once
// When each recording was made within the session: a change of friction, as in a gear that warms
// up, and a wandering torque offset occur over the session, not within one recording.
//
// The recordings' clocks are used where they follow each other without overlap. Where each
// recording counts from its own zero, recordings are assumed to have been made one after another in
// the dataset's order; the time between them is then unknown and left out.

#include <vector>

#include "joint/recording.h"

namespace tribolog::method::session {

struct SessionTimes {
  std::vector<double> begin_s;  ///< Of each recording's first sample, from the session's start.
  double whole_s{};             ///< From the first sample of all to the last.
  bool by_clock{};              ///< By the recordings' own clock; else one after the other.

  /// Share of the session that has passed at time t_s of the recording's own clock, 0 to 1.
  [[nodiscard]] double share(std::size_t recording, const joint::Recording& r, double t_s) const {
    return whole_s > 0 ? (begin_s[recording] + t_s - r.t_s.front()) / whole_s : 0.0;
  }
};

SessionTimes session_times(const std::vector<joint::Recording>& recordings);

}  // namespace tribolog::method::session
