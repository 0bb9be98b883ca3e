#pragma once
// Which of two fits to the same data describes them better, beyond doubt.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace tribolog::statistics {

/// Whether the first fit's residuals are smaller than the second's: by at least `least_gain` of
/// their rms, and by more than the scatter of the gain from block to block allows at 95 % (Q. H.
/// Vuong, Econometrica 57 (1989) 307-333; residuals within a block may be correlated). The gain of
/// a block is the logarithm of its sums of squares' ratio: each has a noise of its own size.
/// @param block_of_row numbers of the blocks, of any order; at least two differ.
bool leaves_less(const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                 const std::vector<std::size_t>& block_of_row, double least_gain);

}  // namespace tribolog::statistics
