#pragma once
// Break-away ramps: the joint stands, the torque rises at a steady rate, until the joint slides or
// the ramp ends.

#include <cstddef>
#include <vector>

#include "inspect/motion/angle_trace.h"

namespace tribolog {

struct TorqueRamp {
  std::size_t first{};
  std::size_t last{};
  double rate{};      ///< Of the effort, in its unit a second; signed.
  bool joint_slid{};  ///< It moved far more in the second half than in the first.
};

/// @param first, last stretch looked at.
/// @param floor_rad noise floor of the angle.
/// @return ramps of a second or longer that rise by 3 % of the effort's range or more, and by a
/// tenth where the joint does not move; none without effort.
std::vector<TorqueRamp> find_torque_ramps(const AngleTrace& trace, std::size_t first,
                                          std::size_t last, double floor_rad);

}  // namespace tribolog
