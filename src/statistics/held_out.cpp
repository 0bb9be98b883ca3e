#include "statistics/held_out.h"

#include <cmath>
#include <limits>

#include "statistics/linear_systems.h"

namespace tribolog::statistics {

std::vector<double> held_out_errors(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y,
                                    const std::vector<std::size_t>& group) {
  const Eigen::VectorXd norms =
      columns.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
  const Eigen::MatrixXd scaled = columns * norms.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd all = scaled.transpose() * scaled;
  const Eigen::VectorXd all_y = scaled.transpose() * y;
  std::vector<double> errors;
  for (std::size_t first = 0; first < group.size();) {
    std::size_t last = first;
    while (last < group.size() && group[last] == group[first]) ++last;
    const auto from = static_cast<Eigen::Index>(first);
    const auto rows = static_cast<Eigen::Index>(last - first);
    const Eigen::MatrixXd part = scaled.middleRows(from, rows);
    const Eigen::VectorXd c = solve_normal(all - part.transpose() * part,
                                           all_y - part.transpose() * y.segment(from, rows));
    errors.push_back((y.segment(from, rows) - part * c).squaredNorm() / static_cast<double>(rows));
    first = last;
  }
  return errors;
}

ErrorDifference difference(const std::vector<double>& one, const std::vector<double>& other) {
  const auto n = static_cast<double>(one.size());
  ErrorDifference out;
  for (std::size_t i = 0; i < one.size(); ++i) out.mean += (one[i] - other[i]) / n;
  double squares = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    squares += std::pow(one[i] - other[i] - out.mean, 2);
  }
  out.standard_error =
      n > 1 ? std::sqrt(squares / (n * (n - 1))) : std::numeric_limits<double>::infinity();
  return out;
}

double root_mean(const std::vector<double>& squares) {
  double sum = 0;
  for (const double s : squares) sum += s;
  return std::sqrt(sum / static_cast<double>(squares.size()));
}

}  // namespace tribolog::statistics
