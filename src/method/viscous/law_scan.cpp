#include "method/viscous/law_scan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Dense>

namespace tribolog::method::viscous {
namespace {

constexpr double worst_normal_condition =
    1e-10;  // of the normal matrix, columns scaled to length 1

struct WeightedFit {
  bool is_distinct{};
  Eigen::VectorXd x, error;
  double chi2{std::numeric_limits<double>::infinity()};
};

WeightedFit weighted_fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y) {
  WeightedFit out;
  const Eigen::VectorXd norms = columns.colwise().norm().transpose();
  if (!(norms.minCoeff() > 1e-6 * norms.maxCoeff())) return out;
  const Eigen::MatrixXd unit = columns * norms.cwiseInverse().asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> gram(unit.transpose() * unit);
  if (!(gram.vectorD().minCoeff() > worst_normal_condition)) return out;
  const Eigen::VectorXd x = gram.solve(unit.transpose() * y);
  const Eigen::MatrixXd inverse =
      gram.solve(Eigen::MatrixXd::Identity(columns.cols(), columns.cols()));
  out.is_distinct = true;
  out.chi2 = (y - unit * x).squaredNorm();
  out.x = x.cwiseQuotient(norms);
  out.error = inverse.diagonal().cwiseSqrt().cwiseQuotient(norms);
  return out;
}

/// Rows scaled by their weights: constant, viscous term, load.
struct Rows {
  Eigen::VectorXd weight, friction, share;  // share: of the fastest speed
  double fastest{};
  Eigen::MatrixXd fixed;

  Rows(const std::vector<SpeedMean>& means, double scatter2, bool load) {
    const auto n = static_cast<Eigen::Index>(means.size());
    weight.resize(n);
    friction.resize(n);
    share.resize(n);
    fixed = Eigen::MatrixXd::Zero(n, load ? 3 : 2);
    for (const SpeedMean& m : means) fastest = std::max(fastest, m.speed_rad_s);
    for (Eigen::Index i = 0; i < n; ++i) {
      const SpeedMean& m = means[static_cast<std::size_t>(i)];
      weight(i) = 1 / std::sqrt(m.variance + scatter2);
      friction(i) = weight(i) * m.friction_Nm;
      share(i) = m.speed_rad_s / fastest;
      fixed(i, 0) = weight(i);
      if (load) fixed(i, 2) = weight(i) * m.load;
    }
  }
  void raise(double power) { fixed.col(1) = weight.array() * share.array().pow(power); }
};

void take(const WeightedFit& s, double power, double fastest, bool load, LawPoint& to) {
  to.power = power;
  to.chi2 = s.chi2;
  to.coulomb_Nm = s.x(0);
  to.coulomb_error = s.error(0);
  to.slope = power * s.x(1) / fastest;
  to.slope_error = power * s.error(1) / fastest;
  if (load) to.load_Nm = s.x(2);
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
        columns.col(fixed) =
            rows.weight.array() *
            (-(rows.share.array() * rows.fastest / point.speed_rad_s).pow(exponent)).exp();
        WeightedFit s = weighted_fit(columns, rows.friction);
        if (!s.is_distinct) continue;
        if (s.x(1) < 0) {
          // Friction that falls with speed all along: the best law a joint can have has no slope.
          Eigen::MatrixXd without(columns.rows(), fixed);
          without << columns.col(0), columns.rightCols(fixed - 1);
          const WeightedFit level = weighted_fit(without, rows.friction);
          if (!level.is_distinct) continue;
          const double slope_error = s.error(1);
          s.chi2 = level.chi2;
          s.x(0) = level.x(0);
          s.x(1) = 0;
          if (grid.load) s.x(2) = level.x(1);
          s.x(fixed) = level.x(fixed - 1);
          s.error(0) = level.error(0);
          s.error(1) = slope_error;
        }
        if (s.x(0) < 0 || s.x(fixed) < 0) continue;
        take(s, power, rows.fastest, grid.load, point);
        point.excess_Nm = s.x(fixed);
        points.push_back(point);
      }
    }
  }
  return points;
}

}  // namespace tribolog::method::viscous
