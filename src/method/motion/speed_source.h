#pragma once
// How the speed of each recording is found. Never from a logged speed: that is often filtered,
// delayed or wrongly scaled, and the angle has it all; the logged one is held against it by the
// checks on the data.

#include <cstddef>
#include <string>
#include <vector>

#include "joint/dataset.h"

namespace tribolog {

struct SpeedSource {
  std::string recording;
  Role role{};
  bool is_logged{};      ///< A speed is logged too.
  std::size_t window{};  ///< Samples from which a local slope of the angle is made.
  double window_s{};     ///< Their duration at the median interval.
  double cut_off_Hz{};   ///< -3 dB of that derivative; see local_slope.h.
};

/// One for each recording of two samples or more.
std::vector<SpeedSource> speed_sources(const std::vector<Recording>& recordings);

}  // namespace tribolog
