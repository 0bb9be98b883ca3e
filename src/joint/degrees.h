#pragma once
// Degrees, which people read and files state, and radians, in which everything is computed.

#include <numbers>

namespace tribolog::joint {

inline constexpr double degrees_per_rad = 180 / std::numbers::pi;
inline constexpr double rad_per_degree = std::numbers::pi / 180;

}  // namespace tribolog::joint
