#pragma once
// Internal to the checks: torque of rising against torque of falling strokes at equal angle.
// Gravity and all else that depends on the angle alone drops out; friction remains.

#include <vector>

#include "method/checks/checked_recordings.h"

namespace tribolog::method::checks {

struct DirectionDifference {
  double rising_travel_rad{};
  double falling_travel_rad{};
  double common_share{};  ///< Share of the smaller range of angles that both directions passed.
  std::size_t common_bins{};
  double friction_Nm{};    ///< Half the mean difference, motor side; positive: it dissipates.
  double half_width_Nm{};  ///< 95 %, from the scatter of the bins.
};

/// @param recordings those of one role, taken together.
/// @param with_torque false: only the travels and the common share.
DirectionDifference direction_difference(const std::vector<const CheckedRecording*>& recordings,
                                         bool with_torque);

}  // namespace tribolog::method::checks
