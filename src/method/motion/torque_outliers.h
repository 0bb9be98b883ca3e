#pragma once
// Single samples of the torque that are no torque: far off their neighbours on either side, which
// agree. They are replaced by the line between these, and counted.
//
// Hampel's filter: a sample is compared with the median of the seven about it, in units of the
// median absolute deviation of a wider window or of the recording's white noise, whichever is
// larger. A step of friction at a reversal has its like on one side and stays; so does a sample
// beside which the joint speeds up or slows down as it rarely does.
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
  double worst_percent{};  ///< Largest share of one recording's samples.
  std::string recording;   ///< That one.
  double largest_Nm{};     ///< Farthest off its neighbours.
};

/// @param recordings are changed where there are outliers.
TorqueOutliers replace_torque_outliers(std::vector<joint::Recording>& recordings);

/// Indices of the samples that are far off their neighbours.
std::vector<std::size_t> torque_outliers(const joint::Recording& recording);

}  // namespace tribolog::method::motion
