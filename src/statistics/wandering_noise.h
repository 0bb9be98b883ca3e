#pragma once
// Errors that are correlated for longer than a block: a random walk, a level that wanders.
//
// Blocks of neighbours (block_regression.h) assume that errors of different blocks are independent.
// Where an offset wanders they are not, and the covariance can be too small by any factor. The
// means of the blocks' errors are modelled as white noise plus a stationary level whose correlation
// falls as exp(-|dt| / time) within a recording (Ornstein and Uhlenbeck); with a time much longer
// than the recording that is a random walk. Both variances and the time by restricted likelihood,
// that of what the columns cannot take up (H. D. Patterson, R. Thompson, Biometrika 58 (1971)
// 545-554), for a fit absorbs most of a slow error and its residuals look small.

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace tribolog::statistics {

/// Blocks of neighbours in time, one row each.
struct BlockMeans {
  Eigen::MatrixXd columns;    ///< Means of the fit's columns.
  Eigen::VectorXd residuals;  ///< Means of the fit's residuals.
  Eigen::VectorXd samples;    ///< Number of samples in each, > 0.
  Eigen::VectorXd time_s;     ///< Of the block's middle.
  std::vector<std::size_t> recording;
  /// Shift of the coefficients by an error of 1 throughout a block (one column each).
  Eigen::MatrixXd effects;
};

struct WanderingNoise {
  double standard_deviation{};  ///< Of the wandering level; its possible absence is averaged in.
  double doubt{};               ///< Posterior probability that nothing wanders, 0 to 1.
  /// Shifts of the coefficients by independent errors of unit variance, one column each: wandering
  /// level and white means together. The covariance is the sum of their outer products.
  Eigen::MatrixXd shifts;
};

/// Absent with too few blocks, with residuals that are all zero, and where white noise alone is
/// likely enough: there an average over all that few blocks allow would be far too wide.
std::optional<WanderingNoise> wandering_noise(const BlockMeans& blocks);

}  // namespace tribolog::statistics
