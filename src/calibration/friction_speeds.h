#pragma once
// Friction at speeds of the motor: a few of them for a table, either side of the gear, and where it
// is usable.

#include <cstddef>
#include <vector>

#include "calibration/quantity_verdict.h"

namespace tribolog::calibration {

/// Of a list, enough for a table that people read.
inline constexpr std::size_t speeds_of_a_table = 5;

/// At the joint: speed / |n|, torque × |n|.
FrictionAtSpeed at_joint(FrictionAtSpeed at_motor, double gear_ratio);

/// So many of them, evenly spaced in the logarithm of the speed from the first to the last: of each
/// the nearest that is there, none twice. @param speeds_rad_s rising, > 0.
/// @return their indices, rising.
std::vector<std::size_t> evenly_in_log(const std::vector<double>& speeds_rad_s, std::size_t count);
std::vector<FrictionAtSpeed> evenly_in_log(const std::vector<FrictionAtSpeed>& all,
                                           std::size_t count);

struct SpeedRange {
  double low_rad_s{};
  double high_rad_s{};
};

/// The stretches without a speed that is not usable, rising; where there are more than `most`,
/// those of the most speeds.
std::vector<SpeedRange> usable_ranges(const std::vector<FrictionAtSpeed>& all, std::size_t most);

}  // namespace tribolog::calibration
