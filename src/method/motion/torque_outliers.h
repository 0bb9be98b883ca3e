#pragma once
// Single outliers of the torque: far from their neighbours on either side, which agree. They are
// replaced by linear interpolation between these, and counted.
//
// Hampel's filter: a sample is compared with the median of the seven about it, in units of the
// median absolute deviation of a wider window or of the recording's white noise, whichever is
// larger. A step of friction at a reversal agrees with one side and is kept; so is a sample near
// which the joint accelerates or decelerates unusually. A sample that is off by
// more than four times the torque's usual range, and its usual size, is not the joint's,
// wherever it is.
//
// It fails where the log is too coarse for the joint: spikes may then be its motion. A recording
// of which more than a tenth would be replaced is left as it is.

#include <cstddef>
#include <string>
#include <vector>

#include "joint/recording.h"

namespace tribolog::method::motion {

struct TorqueOutliers {
  std::size_t replaced{};  ///< In all recordings.
  double worst_percent{};  ///< Largest share of a recording's samples [%].
  std::string recording;   ///< The recording with that share.
  double largest_Nm{};     ///< Largest deviation of an outlier from its neighbours.
};

/// @param recordings modified where there are outliers.
TorqueOutliers replace_torque_outliers(std::vector<joint::Recording>& recordings);

/// Indices of the samples that are far from their neighbours.
std::vector<std::size_t> torque_outliers(const joint::Recording& recording);

}  // namespace tribolog::method::motion
