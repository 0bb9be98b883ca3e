#pragma once
// Break-away ramps: the joint stands, the torque rises at a steady rate, until the joint slides or
// the ramp ends.

#include <cstddef>
#include <vector>

#include "inspect/motion/angle_trace.h"

namespace tribolog::inspect::motion {

struct TorqueRamp {
  std::size_t first{};
  std::size_t last{};
  double rate{};      ///< Of the effort, in its unit a second; signed.
  bool joint_slid{};  ///< It moved far more in the second half than in the first.
};

/// The ramps of a log's effort.
class TorqueRampFinder {
 public:
  /// @param trace outlives the finder.
  /// @param floor_rad noise floor of the angle.
  TorqueRampFinder(const AngleTrace& trace, double floor_rad);

  /// @param first, last stretch looked at.
  /// @return ramps of a second or longer that rise by 3 % of the effort's range or more, and by a
  /// tenth where the joint does not move; none without effort.
  [[nodiscard]] std::vector<TorqueRamp> between(std::size_t first, std::size_t last) const;

 private:
  const AngleTrace& trace_;
  double floor_rad_;
  double floor_{};  ///< Noise floor of the effort.
  double range_{};  ///< Of the effort.
};

}  // namespace tribolog::inspect::motion
