#pragma once
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace tribolog::test {

/// How many seeds a test of coverage takes: few for every change, and many where TRIBOLOG_ALL_SEEDS
/// is set, as `tests/nightly.sh coverage` does.
inline std::size_t seeds_of(std::size_t every_change, std::size_t every_night) {
  return std::getenv("TRIBOLOG_ALL_SEEDS") != nullptr ? every_night : every_change;
}

/// The least share of so many 95 % intervals that must hold the truth: 4 standard errors below.
inline double least_coverage(std::size_t seeds) {
  return 0.95 - 4 * std::sqrt(0.95 * 0.05 / static_cast<double>(seeds));
}

}  // namespace tribolog::test
