#pragma once
// Internal to the viscous stage: the runs at each speed as one friction, the mean of the
// directions.

#include <cstddef>
#include <limits>
#include <vector>

#include "method/viscous/curve_model.h"
#include "method/viscous/law_scan.h"

namespace tribolog::method::viscous {

/// One speed with all of its runs.
struct FrictionAtSpeed {
  SpeedMean mean;
  bool has_both{};           ///< Directions.
  double half_difference{};  ///< Friction of rising less that of falling, halved; if it has both.
  std::vector<std::size_t> runs;
};

/// Of each group of runs; no variance is smaller than motion and method allow.
std::vector<FrictionAtSpeed> speeds_of(const std::vector<CurveSample>& samples,
                                       const CurveModel& terms);

inline constexpr std::size_t no_speed = std::numeric_limits<std::size_t>::max();

/// @param without the speed that is left out.
std::vector<SpeedMean> means_of(const std::vector<FrictionAtSpeed>& speeds,
                                std::size_t without = no_speed);

}  // namespace tribolog::method::viscous
