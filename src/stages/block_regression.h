#pragma once
// Linear least squares whose covariance does not believe that residuals are independent.
//
// Model: y = X c + e. What a robot's torque leaves over a smooth fit is ripple, not white noise:
// neighbours are correlated, and the textbook covariance is far too small. Rows are grouped into
// blocks of neighbours; the covariance is the sandwich (X'X)^-1 (sum over blocks of s s') (X'X)^-1
// with s = X_b' e_b, which is right for any correlation within a block and none between blocks.
// It fails where correlation reaches over more than a block; few blocks make it coarse, which the
// t factor pays for.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace tribolog {

struct BlockRegression {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
  Eigen::VectorXd residuals;
  double residual_sd{};
  double condition{};  ///< Of X with its columns scaled to length 1; large: columns alike.
  double t_factor{};   ///< For 95 % intervals: half width = t_factor * sqrt(variance).
};

/// @param block_of_row non-decreasing block number of each row, starting at 0.
/// @throw std::invalid_argument if there are fewer rows than columns or sizes differ.
BlockRegression block_regression(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                 const std::vector<std::size_t>& block_of_row);

struct BlockCovariance {
  Eigen::MatrixXd covariance;
  double t_factor{};  ///< As above.
};

/// The sandwich alone, where X has been factored already.
/// @param r_inverse inverse of the triangular factor R of X = Q R.
BlockCovariance block_covariance(const Eigen::MatrixXd& x, const Eigen::VectorXd& residuals,
                                 const Eigen::MatrixXd& r_inverse,
                                 const std::vector<std::size_t>& block_of_row);

/// Blocks for rows that follow each other in time: `per_group` blocks of equal size within each
/// run of equal `group`, but none smaller than 5 rows.
std::vector<std::size_t> equal_blocks(const std::vector<std::size_t>& group, std::size_t per_group);

}  // namespace tribolog
