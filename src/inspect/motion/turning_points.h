#pragma once
// Where a signal turns, smaller wiggles passed over.

#include <cstddef>
#include <vector>

namespace tribolog {

/// Indices of the alternating extremes within [first, last] that differ by `threshold` (> 0) or
/// more from their neighbours in the list. Empty where the signal stays within the threshold.
std::vector<std::size_t> turning_points(const std::vector<double>& signal, std::size_t first,
                                        std::size_t last, double threshold);

}  // namespace tribolog
