#pragma once
// Linear least squares whose covariance does not assume independent residuals.
//
// Model: y = X c + e. The residuals of a robot's torque about a smooth fit are ripple, not white
// noise: neighbours are correlated, and the textbook covariance is far too small. Rows are grouped
// into blocks of neighbours; the covariance is the sandwich (X'X)^-1 (sum over blocks of s s')
// (X'X)^-1 with s = X_b' e_b, which is valid for any correlation within a block and none between
// blocks. It fails where correlation extends beyond a block.
//
// Residuals are smaller than errors, most of all where one block determines a coefficient. Each
// block's residuals are therefore multiplied by (I - H_bb)^(-1/2), H the projection onto the
// columns: the covariance is then unbiased for white errors. With few blocks it is coarse, for some
// coefficients more than for others: degrees of freedom after Satterthwaite, for white errors. Both
// after R. M. Bell and D. F. McCaffrey, Survey Methodology 28 (2002) 169-181. What only one block
// determines has no scatter between blocks: its variance is that of white noise.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace tribolog::statistics {

struct BlockRegression {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
  Eigen::VectorXd residuals;
  double residual_sd{};
  double condition{};  ///< Of X with its columns scaled to length 1; large: nearly collinear.
  /// Shift of the coefficients by the error of each block (one column); the covariance is the sum
  /// of their outer products. A bootstrap draws blocks from here.
  Eigen::MatrixXd block_shifts;
  Eigen::VectorXd freedom;  ///< Degrees of freedom of each coefficient's variance, >= 1.

  /// Half width of the 95 % interval of coefficient k.
  [[nodiscard]] double half_width(Eigen::Index k) const;
  /// Of a quantity with this gradient with respect to the coefficients.
  [[nodiscard]] double standard_error_along(const Eigen::VectorXd& gradient) const;
  /// The fewest degrees of freedom among the coefficients that it depends on.
  [[nodiscard]] double freedom_along(const Eigen::VectorXd& gradient) const;
  [[nodiscard]] double half_width_along(const Eigen::VectorXd& gradient) const;
};

/// @param block_of_row block number of each row; every number from 0 to the largest occurs; rows of
/// a block need not be consecutive.
/// @throw std::invalid_argument if there are fewer rows than columns or sizes differ.
BlockRegression block_regression(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                 const std::vector<std::size_t>& block_of_row);

/// Blocks for rows in the order of time: `per_group` blocks of equal size within each run of equal
/// `group`, but none smaller than 5 rows.
std::vector<std::size_t> equal_blocks(const std::vector<std::size_t>& group, std::size_t per_group);

}  // namespace tribolog::statistics
