#include "method/viscous/law_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Cholesky>

namespace tribolog::method::viscous {
namespace {

constexpr double worst_normal_condition =
    1e-10;  // of the normal matrix, columns scaled to length 1

constexpr std::size_t most_terms = 4;  // constant, viscous term, load, excess

struct WeightedFit {
  bool is_distinct{};
  std::array<double, most_terms> x{}, error{};
  double chi2{std::numeric_limits<double>::infinity()};
};

/// By the normal equations of columns scaled to length 1; tens of thousands of laws are tried for
/// one answer, so nothing is allocated: terms that a law does not have are equations of their own.
WeightedFit weighted_fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y) {
  using Vector = Eigen::Matrix<double, most_terms, 1>;
  using Products = Eigen::Matrix<double, most_terms, most_terms>;
  const Eigen::Index terms = columns.cols();
  WeightedFit out;
  Products products = Products::Identity();
  products.topLeftCorner(terms, terms) = columns.transpose().lazyProduct(columns);
  const Vector norms = products.diagonal().cwiseSqrt();
  const auto own = norms.head(terms);
  if (!(own.minCoeff() > 1e-6 * own.maxCoeff())) return out;
  const Vector scale = norms.cwiseInverse();
  const Eigen::LDLT<Products> gram(scale.asDiagonal() * products * scale.asDiagonal());
  if (!(gram.vectorD().minCoeff() > worst_normal_condition)) return out;
  Vector seen = Vector::Zero();
  seen.head(terms) = columns.transpose().lazyProduct(y);
  const Vector x = gram.solve(scale.cwiseProduct(seen)).cwiseProduct(scale);
  const Products inverse = gram.solve(Products::Identity());
  for (Eigen::Index i = 0; i < terms; ++i) {
    const auto k = static_cast<std::size_t>(i);
    out.x[k] = x(i);
    out.error[k] = std::sqrt(inverse(i, i)) * scale(i);
  }
  out.is_distinct = true;
  out.chi2 = (y - columns.lazyProduct(x.head(terms))).squaredNorm();
  return out;
}

/// Rows scaled by their weights: constant, viscous term, load.
struct Rows {
  Eigen::ArrayXd weight, log_share;  // share: of the fastest speed
  Eigen::VectorXd friction;
  double fastest{};
  Eigen::MatrixXd fixed;

  Rows(const std::vector<SpeedMean>& means, double scatter2, bool load) {
    const auto n = static_cast<Eigen::Index>(means.size());
    weight.resize(n);
    friction.resize(n);
    log_share.resize(n);
    fixed = Eigen::MatrixXd::Zero(n, load ? 3 : 2);
    for (const SpeedMean& m : means) fastest = std::max(fastest, m.speed_rad_s);
    for (Eigen::Index i = 0; i < n; ++i) {
      const SpeedMean& m = means[static_cast<std::size_t>(i)];
      weight(i) = 1 / std::sqrt(m.variance + scatter2);
      friction(i) = weight(i) * m.friction_Nm;
      log_share(i) = std::log(m.speed_rad_s / fastest);
      fixed(i, 0) = weight(i);
      if (load) fixed(i, 2) = weight(i) * m.load;
    }
  }
  void raise(double power) { fixed.col(1) = weight * (power * log_share).exp(); }
  /// exp(-(w/ws)^d), weighted.
  [[nodiscard]] Eigen::ArrayXd excess(double speed_rad_s, double exponent) const {
    const double log_speed = std::log(speed_rad_s / fastest);
    return weight * (-(exponent * (log_share - log_speed)).exp()).exp();
  }
};

void take(const WeightedFit& s, double power, double fastest, bool load, LawPoint& to) {
  to.power = power;
  to.chi2 = s.chi2;
  to.coulomb_Nm = s.x[0];
  to.coulomb_error = s.error[0];
  to.slope = power * s.x[1] / fastest;
  to.slope_error = power * s.error[1] / fastest;
  if (load) to.load_Nm = s.x[2];
}

}  // namespace

LawPoint line_at(const std::vector<SpeedMean>& means, double scatter2, double power, bool load) {
  Rows rows(means, scatter2, load);
  rows.raise(power);
  LawPoint line;
  const WeightedFit s = weighted_fit(rows.fixed, rows.friction);
  line.chi2 = s.chi2;
  if (s.is_distinct) take(s, power, rows.fastest, load, line);
  return line;
}

std::vector<LawPoint> scan_laws(const std::vector<SpeedMean>& means, double scatter2,
                                const LawGrid& grid, std::size_t speeds) {
  Rows rows(means, scatter2, grid.load);
  const Eigen::Index fixed = rows.fixed.cols();
  const auto excess = static_cast<std::size_t>(fixed);
  Eigen::MatrixXd columns(rows.fixed.rows(), fixed + 1);
  std::vector<LawPoint> points;
  for (const double power : grid.powers) {
    rows.raise(power);
    columns.leftCols(fixed) = rows.fixed;
    for (const double exponent : grid.exponents) {
      for (std::size_t k = 0; k < speeds; ++k) {
        const double along = static_cast<double>(k) / static_cast<double>(speeds - 1);
        LawPoint point;
        point.has_excess = true;
        point.exponent = exponent;
        point.speed_rad_s =
            grid.slowest_speed * std::pow(grid.fastest_speed / grid.slowest_speed, along);
        columns.col(fixed) = rows.excess(point.speed_rad_s, exponent);
        WeightedFit s = weighted_fit(columns, rows.friction);
        if (!s.is_distinct) continue;
        if (s.x[1] < 0) {
          // Friction that falls with speed all along: the best law a joint can have has no slope.
          Eigen::MatrixXd without(columns.rows(), fixed);
          without << columns.col(0), columns.rightCols(fixed - 1);
          const WeightedFit level = weighted_fit(without, rows.friction);
          if (!level.is_distinct) continue;
          const double slope_error = s.error[1];
          s.chi2 = level.chi2;
          s.x[0] = level.x[0];
          s.x[1] = 0;
          if (grid.load) s.x[2] = level.x[1];
          s.x[excess] = level.x[excess - 1];
          s.error[0] = level.error[0];
          s.error[1] = slope_error;
        }
        if (s.x[0] < 0 || s.x[excess] < 0) continue;
        take(s, power, rows.fastest, grid.load, point);
        point.excess_Nm = s.x[excess];
        points.push_back(point);
      }
    }
  }
  return points;
}

}  // namespace tribolog::method::viscous
