#pragma once
// The white noise of a smooth signal, told from the signal itself.

#include <vector>

namespace tribolog {

/// Standard deviation from third differences, of which a parabola leaves none; their median is not
/// moved by kinks and jumps that are few. 0 of fewer than four values.
double white_noise_of(const std::vector<double>& evenly_sampled);

}  // namespace tribolog
