#include "stages/block_regression.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Dense>

#include "stages/student_t.h"

namespace tribolog {

BlockRegression block_regression(const Eigen::MatrixXd& x, const Eigen::VectorXd& y,
                                 const std::vector<std::size_t>& block_of_row) {
  const Eigen::Index rows = x.rows();
  const Eigen::Index columns = x.cols();
  if (rows < columns || y.size() != rows || block_of_row.size() != static_cast<std::size_t>(rows)) {
    throw std::invalid_argument("block regression needs as many rows as columns, and equal sizes");
  }
  const Eigen::VectorXd norms =
      x.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
  const Eigen::MatrixXd scaled = x * norms.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(r);

  BlockRegression out;
  const Eigen::VectorXd c = qr.solve(y);
  const auto& s = svd.singularValues();
  out.condition = s(columns - 1) > 0 ? s(0) / s(columns - 1) : INFINITY;
  out.coefficients = c.cwiseQuotient(norms);
  out.residuals = y - scaled * c;
  const double freedom = std::max<double>(1.0, static_cast<double>(rows - columns));
  out.residual_sd = std::sqrt(out.residuals.squaredNorm() / freedom);

  const Eigen::MatrixXd r_inverse =
      r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(columns, columns));
  const BlockCovariance around = block_covariance(scaled, out.residuals, r_inverse, block_of_row);
  out.covariance =
      norms.cwiseInverse().asDiagonal() * around.covariance * norms.cwiseInverse().asDiagonal();
  out.t_factor = around.t_factor;
  return out;
}

BlockCovariance block_covariance(const Eigen::MatrixXd& x, const Eigen::VectorXd& residuals,
                                 const Eigen::MatrixXd& r_inverse,
                                 const std::vector<std::size_t>& block_of_row) {
  const Eigen::Index columns = x.cols();
  const std::size_t blocks = block_of_row.empty() ? 0 : block_of_row.back() + 1;
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(columns, static_cast<Eigen::Index>(blocks));
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    scores.col(static_cast<Eigen::Index>(block_of_row[static_cast<std::size_t>(i)])) +=
        residuals(i) * x.row(i).transpose();
  }
  const Eigen::MatrixXd bread = r_inverse * r_inverse.transpose();
  const auto m = static_cast<double>(blocks);
  // Each column costs a degree of freedom among the blocks.
  const double spare = std::max(1.0, m - static_cast<double>(columns));
  const Eigen::MatrixXd meat = scores * scores.transpose() * (m / spare);
  return {bread * meat * bread, student_t_975(spare)};
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

}  // namespace tribolog
