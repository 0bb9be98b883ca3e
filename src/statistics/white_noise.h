#pragma once
// White noise of a signal from the third differences of neighbouring samples, in which everything
// slower than a few samples drops out: a parabola leaves none, white noise stays 20 times over.

#include <vector>

namespace tribolog::statistics {

/// Standard deviation of normal noise by the median of its sizes.
inline constexpr double normal_sd_by_median_size = 1.4826;

/// y3 - 3 y2 + 3 y1 - y0 of four neighbours.
double third_difference(const double* four_neighbours);

/// Those of a whole signal: three fewer than it has samples, none of a shorter one.
std::vector<double> third_differences(const std::vector<double>& signal);

/// Variance of the white noise by the mean square of third differences, on which jumps weigh; 0 of
/// none.
double white_variance(const std::vector<double>& third_differences);

/// Standard deviation of the white noise by the median of third differences, which passes over rare
/// jumps; 0 of none.
double white_sd_beside_jumps(std::vector<double> third_differences);

}  // namespace tribolog::statistics
