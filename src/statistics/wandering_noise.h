#pragma once
// Errors that hang together for longer than a block: a random walk, a level that wanders.
//
// Blocks of neighbours (block_regression.h) take errors of one block to tell nothing of the next
// one's. Where an offset wanders they do, and the covariance is too small by any factor. Modelled
// are the means of the blocks' errors: white, and beside it a stationary level whose correlation
// falls as exp(-|dt| / time) within a recording (Ornstein and Uhlenbeck); much longer than the
// recording that is a random walk. Both variances and the time by restricted maximum likelihood:
// of what the columns cannot take up (H. D. Patterson, R. Thompson, Biometrika 58 (1971) 545-554),
// for a fit swallows most of a slow error and its residuals look small.

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace tribolog::statistics {

/// Blocks of neighbours in time, one row each.
struct BlockMeans {
  Eigen::MatrixXd columns;    ///< Means of the fit's columns.
  Eigen::VectorXd residuals;  ///< Means of what the fit leaves.
  Eigen::VectorXd samples;    ///< Their number, > 0.
  Eigen::VectorXd time_s;     ///< Of the block's middle.
  std::vector<std::size_t> recording;
  /// What an error of 1 throughout a block (one column each) does to the coefficients.
  Eigen::MatrixXd effects;
};

struct WanderingNoise {
  double standard_deviation{};  ///< Of the wandering level; 0 counted in where it may be none.
  double doubt{};               ///< Probability that nothing wanders, 0 to 1.
  /// What independent errors of unit variance, one column each, do to the coefficients: wandering
  /// level and white means together. The covariance is the sum of their squares.
  Eigen::MatrixXd shifts;
};

/// Absent for too few blocks, for residuals without any error, and where white noise is likely
/// enough: what is averaged over all that few blocks allow is far too wide there.
std::optional<WanderingNoise> wandering_noise(const BlockMeans& blocks);

}  // namespace tribolog::statistics
