#include "method/session/condition_regression.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::session {
namespace {

// More samples in a cell do not make it more trustworthy: the remaining error of its mean is not
// noise.
constexpr double most_samples = 100;

/// Removes from each column the part that is a level of the pair: sum of direction times the
/// column. @return that part, one row for each pair.
Eigen::MatrixXd take_levels_out(const StrokePairs& strokes, const Eigen::VectorXd& weight,
                                Eigen::MatrixXd& columns) {
  const auto pairs = static_cast<Eigen::Index>(strokes.pairs.size());
  Eigen::MatrixXd level = Eigen::MatrixXd::Zero(pairs, columns.cols());
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(pairs);
  for (std::size_t i = 0; i < strokes.cells.size(); ++i) {
    const StrokeCell& cell = strokes.cells[i];
    const auto row = static_cast<Eigen::Index>(i);
    const auto pair = static_cast<Eigen::Index>(cell.pair);
    const double w2 = weight(row) * weight(row);
    level.row(pair) += w2 * cell.direction * columns.row(row);
    sum(pair) += w2;
  }
  for (Eigen::Index p = 0; p < pairs; ++p) level.row(p) /= std::max(sum(p), 1e-300);
  for (std::size_t i = 0; i < strokes.cells.size(); ++i) {
    const StrokeCell& cell = strokes.cells[i];
    columns.row(static_cast<Eigen::Index>(i)) -=
        cell.direction * level.row(static_cast<Eigen::Index>(cell.pair));
  }
  return level;
}

}  // namespace

double ConditionFit::chance_of(Eigen::Index first, Eigen::Index count) const {
  if (first < 0) return 1;
  const Eigen::VectorXd c = regression.coefficients.segment(first, count);
  const Eigen::MatrixXd v = regression.covariance.block(first, first, count, count);
  const double wald = statistics::mahalanobis_square(v, c);
  // After Pan and Wall (2002): of Hotelling's kind, with the freedom of the covariance.
  const double freedom = regression.freedom.segment(first, count).minCoeff();
  const double below = std::max(1.0, freedom - static_cast<double>(count) + 1);
  return statistics::f_upper_tail(
      wald * below / (std::max(1.0, freedom) * static_cast<double>(count)),
      static_cast<double>(count), below);
}

Eigen::RowVector3d angle_terms(double x) { return {std::sin(x), std::cos(2 * x), std::sin(2 * x)}; }

ConditionFit fit_conditions(const StrokePairs& strokes, const GravityGuess& gravity,
                            const ReferenceCondition& reference, const ConditionTerms& terms,
                            const std::vector<double>& taken_off) {
  ConditionFit fit;
  Eigen::Index next = 0;
  const auto take = [&next](Eigen::Index count) {
    next += count;
    return next - count;
  };
  fit.gravity = take(2);
  if (terms.second_of_angle) fit.second = take(2);
  fit.offset = take(1);
  if (terms.drift_of_offset) fit.offset_drift = take(1);
  if (terms.asymmetry) fit.asymmetry = take(1);
  if (terms.load) fit.load = take(1);
  if (terms.angle) fit.angle = take(3);
  if (terms.lag) fit.lag = take(1);

  const auto rows = static_cast<Eigen::Index>(strokes.cells.size());
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(rows, next + 1);  // the torque is the last column
  Eigen::VectorXd weight(rows);
  std::vector<std::size_t> blocks;
  double mean_level = 0;
  for (const StrokePair& p : strokes.pairs) {
    mean_level += p.friction_Nm / static_cast<double>(strokes.pairs.size());
  }
  for (Eigen::Index row = 0; row < rows; ++row) {
    const StrokeCell& cell = strokes.cells[static_cast<std::size_t>(row)];
    const StrokePair& pair = strokes.pairs[cell.pair];
    const double q = cell.q_rad - gravity.q_peak_rad;
    const double sign = cell.direction;
    weight(row) = std::sqrt(std::min(cell.samples, most_samples));
    x(row, fit.gravity) = std::cos(q);
    x(row, fit.gravity + 1) = std::sin(q);
    if (fit.second >= 0) {
      x(row, fit.second) = std::cos(2 * q);
      x(row, fit.second + 1) = std::sin(2 * q);
    }
    x(row, fit.offset) = 1;
    if (fit.offset_drift >= 0) x(row, fit.offset_drift) = cell.session_share - 0.5;
    if (fit.asymmetry >= 0) x(row, fit.asymmetry) = pair.friction_Nm - mean_level;
    if (fit.load >= 0) {
      x(row, fit.load) = sign * gravity.gravity_Nm * (std::abs(std::cos(q)) - reference.load);
    }
    if (fit.angle >= 0) {
      x.block<1, 3>(row, fit.angle) = sign * pair.friction_Nm * (angle_terms(q) - reference.angle);
    }
    if (fit.lag >= 0) {
      x(row, fit.lag) = sign * gravity.gravity_Nm * pair.speed_rad_s * std::sin(q);
    }
    x(row, next) = cell.torque_Nm;
    if (!taken_off.empty()) x(row, next) -= taken_off[static_cast<std::size_t>(row)];
    blocks.push_back(cell.block);
  }
  const Eigen::MatrixXd level = take_levels_out(strokes, weight, x);
  const Eigen::VectorXd y = weight.cwiseProduct(x.col(next));
  fit.regression = statistics::block_regression(weight.asDiagonal() * x.leftCols(next), y, blocks);

  const auto pairs = static_cast<Eigen::Index>(strokes.pairs.size());
  std::vector<double> squares(strokes.pairs.size(), 0.0);
  std::vector<double> count(strokes.pairs.size(), 0.0);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const std::size_t pair = strokes.cells[static_cast<std::size_t>(row)].pair;
    squares[pair] += std::pow(fit.regression.residuals(row) / weight(row), 2);
    count[pair] += 1;
  }
  const Eigen::VectorXd common = level.leftCols(next).colwise().mean().transpose();
  for (Eigen::Index p = 0; p < pairs; ++p) {
    const Eigen::VectorXd gradient = level.row(p).head(next).transpose();
    fit.level_Nm.push_back(level(p, next) - gradient.dot(fit.regression.coefficients));
    const double n = count[static_cast<std::size_t>(p)];
    const double own = squares[static_cast<std::size_t>(p)] / std::max(1.0, n - 1) / n;
    fit.level_error_Nm.push_back(
        std::sqrt(own + std::pow(fit.regression.standard_error_along(gradient - common), 2)));
  }
  return fit;
}

}  // namespace tribolog::method::session
