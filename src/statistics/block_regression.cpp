#include "statistics/block_regression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::statistics {
namespace {

/// The blocks in coordinates in which the coefficients of white errors are white.
struct WhitenedBlocks {
  std::vector<Eigen::MatrixXd> shares;  ///< Of each block in X'X; they add up to the unit matrix.
  std::vector<Eigen::MatrixXd> corrections;  ///< (I - share)^(-1/2)
  Eigen::MatrixXd shifts;                    ///< Corrected scores, one column for each block.
};

WhitenedBlocks whitened_blocks(const Eigen::MatrixXd& scaled, const BlockRegression& fit,
                               const Eigen::MatrixXd& r_inverse,
                               const std::vector<std::size_t>& block_of_row) {
  // Above this share one block alone determines a direction, and its residual shows nothing.
  constexpr double alone = 0.99;
  const Eigen::Index columns = scaled.cols();
  const std::size_t count = block_of_row.back() + 1;
  WhitenedBlocks out;
  out.shifts = Eigen::MatrixXd::Zero(columns, static_cast<Eigen::Index>(count));
  Eigen::Index first = 0;
  for (std::size_t b = 0; b < count; ++b) {
    Eigen::Index last = first;
    while (last < scaled.rows() && block_of_row[static_cast<std::size_t>(last)] == b) ++last;
    const auto x = scaled.middleRows(first, last - first);
    const Eigen::MatrixXd share = r_inverse.transpose() * (x.transpose() * x) * r_inverse;
    const Eigen::VectorXd score =
        r_inverse.transpose() * (x.transpose() * fit.residuals.segment(first, last - first));
    const EigenSystem eigen = eigen_system(share);
    const Eigen::MatrixXd& u = eigen.vectors;
    Eigen::VectorXd gain(columns);
    Eigen::VectorXd along = u.transpose() * score;
    for (Eigen::Index k = 0; k < columns; ++k) {
      const double lambda = eigen.values(k);
      gain(k) = 1 / std::sqrt(1 - std::clamp(lambda, 0.0, alone));
      along(k) = lambda > alone ? fit.residual_sd : gain(k) * along(k);
    }
    out.shifts.col(static_cast<Eigen::Index>(b)) = u * along;
    out.corrections.emplace_back(u * gain.asDiagonal() * u.transpose());
    out.shares.push_back(share);
    first = last;
  }
  return out;
}

/// Of the variance of `direction` times the whitened coefficients: (tr G)^2 / tr(G^2), G the
/// covariance of the blocks' contributions under white errors.
double degrees_of_freedom(const WhitenedBlocks& blocks, const Eigen::VectorXd& direction) {
  Eigen::MatrixXd common = Eigen::MatrixXd::Zero(direction.size(), direction.size());
  double trace = 0;
  double squares = 0;
  for (std::size_t b = 0; b < blocks.shares.size(); ++b) {
    const Eigen::VectorXd g = blocks.corrections[b] * direction;
    const Eigen::VectorXd v = blocks.shares[b] * g;
    const double own = g.dot(v);
    trace += own - v.squaredNorm();
    squares += own * own - 2 * own * v.squaredNorm();
    common += v * v.transpose();
  }
  squares += common.squaredNorm();
  const double freedom = trace * trace / squares;
  return std::isfinite(freedom) ? std::max(1.0, freedom) : 1.0;
}

/// Infinite for columns that are collinear: nothing is known of their coefficients.
double root_of_variance(double variance) {
  if (!std::isfinite(variance)) return std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(0.0, variance));
}

/// The same with the rows in the order of their blocks.
BlockRegression regression_of_scattered_blocks(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                               const std::vector<std::size_t>& block_of_row) {
  std::vector<Eigen::Index> order(block_of_row.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return block_of_row[static_cast<std::size_t>(a)] < block_of_row[static_cast<std::size_t>(b)];
  });
  Eigen::MatrixXd sorted_x(x.rows(), x.cols());
  Eigen::VectorXd sorted_y(y.size());
  std::vector<std::size_t> blocks;
  for (const Eigen::Index row : order) {
    const auto to = static_cast<Eigen::Index>(blocks.size());
    sorted_x.row(to) = x.row(row);
    sorted_y(to) = y(row);
    blocks.push_back(block_of_row[static_cast<std::size_t>(row)]);
  }
  BlockRegression out = block_regression(sorted_x, sorted_y, blocks);
  const Eigen::VectorXd residuals = out.residuals;
  for (std::size_t i = 0; i < order.size(); ++i) {
    out.residuals(order[i]) = residuals(static_cast<Eigen::Index>(i));
  }
  return out;
}

}  // namespace

BlockRegression block_regression(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                 const std::vector<std::size_t>& block_of_row) {
  const bool fits =
      y.size() == x.rows() && block_of_row.size() == static_cast<std::size_t>(y.size());
  if (fits && !std::is_sorted(block_of_row.begin(), block_of_row.end())) {
    return regression_of_scattered_blocks(x, y, block_of_row);
  }
  const Eigen::Index rows = x.rows();
  const Eigen::Index columns = x.cols();
  if (rows < columns || y.size() != rows || block_of_row.size() != static_cast<std::size_t>(rows)) {
    throw std::invalid_argument("wrong sizes");
  }
  const Eigen::VectorXd norms =
      x.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
  Eigen::MatrixXd scaled = x * norms.cwiseInverse().asDiagonal();
  Eigen::MatrixXd r;
  const Eigen::VectorXd c = least_squares_in_place(scaled, y, r);
  scaled = x * norms.cwiseInverse().asDiagonal();
  const Eigen::VectorXd s = singular_values(r).values;

  BlockRegression out;
  out.condition = s(columns - 1) > 0 ? s(0) / s(columns - 1) : INFINITY;
  out.coefficients = c.cwiseQuotient(norms);
  out.residuals = y - scaled * c;
  const double freedom = std::max<double>(1.0, static_cast<double>(rows - columns));
  out.residual_sd = std::sqrt(out.residuals.squaredNorm() / freedom);

  const Eigen::MatrixXd r_inverse =
      solve_transposed_triangle(r, Eigen::MatrixXd::Identity(columns, columns)).transpose();
  const WhitenedBlocks blocks = whitened_blocks(scaled, out, r_inverse, block_of_row);
  const Eigen::MatrixXd to_coefficients = norms.cwiseInverse().asDiagonal() * r_inverse;
  out.block_shifts = to_coefficients * blocks.shifts;
  out.covariance = out.block_shifts * out.block_shifts.transpose();
  out.freedom.resize(columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    out.freedom(k) = degrees_of_freedom(blocks, r_inverse.row(k).transpose());
  }
  return out;
}

double BlockRegression::half_width(Eigen::Index k) const {
  return student_t_975(freedom(k)) * root_of_variance(covariance(k, k));
}

double BlockRegression::standard_error_along(const Eigen::VectorXd& gradient) const {
  return root_of_variance(gradient.dot(covariance * gradient));
}

double BlockRegression::freedom_along(const Eigen::VectorXd& gradient) const {
  double fewest = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < gradient.size(); ++k) {
    if (gradient(k) != 0) fewest = std::min(fewest, freedom(k));
  }
  return fewest;
}

double BlockRegression::half_width_along(const Eigen::VectorXd& gradient) const {
  return student_t_975(freedom_along(gradient)) * standard_error_along(gradient);
}

std::vector<std::size_t> equal_blocks(const std::vector<std::size_t>& group,
                                      std::size_t per_group) {
  constexpr std::size_t fewest_rows = 5;
  std::vector<std::size_t> blocks(group.size());
  std::size_t next = 0;
  for (std::size_t first = 0; first < group.size();) {
    std::size_t last = first;
    while (last < group.size() && group[last] == group[first]) ++last;
    const std::size_t rows = last - first;
    const std::size_t count = std::clamp<std::size_t>(rows / fewest_rows, 1, per_group);
    for (std::size_t i = first; i < last; ++i) blocks[i] = next + (i - first) * count / rows;
    next += count;
    first = last;
  }
  return blocks;
}

}  // namespace tribolog::statistics
