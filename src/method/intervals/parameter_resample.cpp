#include "method/intervals/parameter_resample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Core>

#include "statistics/block_regression.h"
#include "statistics/linear_systems.h"
#include "statistics/random_stream.h"

namespace tribolog::method::intervals {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Eigen::VectorXd logarithms(const viscous::WaiboerFit& fit) {
  Eigen::VectorXd p(5);
  p << std::log(fit.asperity_torque_Nm.value), std::log(fit.stribeck_speed_rad_s.value),
      std::log(fit.stribeck_power.value), std::log(fit.viscous_coefficient.value),
      std::log(1 - fit.viscous_power.value);
  return p;
}

Eigen::VectorXd measured_of(const std::vector<viscous::CurvePoint>& points) {
  Eigen::VectorXd y(static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < y.size(); ++i)
    y(i) = points[static_cast<std::size_t>(i)].friction_Nm;
  return y;
}

/// Gauss-Newton from the solution of the data as they are.
Eigen::VectorXd refit(std::vector<viscous::CurvePoint> points, const Eigen::VectorXd& y,
                      const Eigen::VectorXd& start) {
  constexpr int steps = 4;
  constexpr double longest = 0.5;  // of a logarithm
  for (Eigen::Index i = 0; i < y.size(); ++i)
    points[static_cast<std::size_t>(i)].friction_Nm = y(i);
  Eigen::VectorXd p = start;
  Eigen::VectorXd r;
  Eigen::MatrixXd j;
  for (int k = 0; k < steps; ++k) {
    viscous::waiboer_residuals(points, p, r, &j);
    Eigen::VectorXd step = statistics::OrthogonalColumns(j).solve(-r);
    const double size = step.cwiseAbs().maxCoeff();
    if (!std::isfinite(size)) return Eigen::VectorXd::Constant(p.size(), nan);
    if (size > longest) step *= longest / size;
    p += step;
    if (size < 1e-9) break;
  }
  return p;
}

}  // namespace

ParameterResampler::ParameterResampler(const viscous::ViscousCurvesResult& curves,
                                       const selection::FrictionParametersResult& fits) {
  const viscous::ViscousCurve* curve = curves.find(fits.curve);
  if (curve == nullptr) return;
  std::vector<std::size_t> order(curves.runs.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(curves.runs[a].speed_rad_s) < std::abs(curves.runs[b].speed_rad_s);
  });
  const auto n = static_cast<Eigen::Index>(order.size());
  gravity_.resize(n);
  angle_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t k = order[static_cast<std::size_t>(i)];
    const viscous::ConstantSpeedRun& run = curves.runs[k];
    const double sign = run.speed_rad_s < 0 ? -1.0 : 1.0;
    points_.push_back({std::abs(run.speed_rad_s), sign * curve->friction_Nm[k]});
    gravity_(i) = -sign * run.mean_cos;
    angle_(i) = -sign * run.mean_sin;
  }
  const Eigen::VectorXd measured = measured_of(points_);
  if (fits.waiboer) {
    waiboer_ = logarithms(*fits.waiboer);
    Eigen::VectorXd r;
    Eigen::MatrixXd j;
    viscous::waiboer_residuals(points_, waiboer_, r, &j);
    waiboer_residuals_ = prepare(j, measured + r, measured, 0);
  }
  if (fits.coulomb_viscous) {
    const selection::CoulombViscousFit& line = *fits.coulomb_viscous;
    while (line_first_ < n &&
           points_[static_cast<std::size_t>(line_first_)].speed_rad_s < line.slowest_rad_s) {
      ++line_first_;
    }
    Eigen::MatrixXd x = Eigen::MatrixXd::Ones(n - line_first_, 2);
    for (Eigen::Index i = line_first_; i < n; ++i) {
      x(i - line_first_, 1) = points_[static_cast<std::size_t>(i)].speed_rad_s;
    }
    const Eigen::Vector2d c(line.coulomb_Nm.value, line.viscous_Nms_rad.value);
    line_solver_ = statistics::inverse_normal(x) * x.transpose();
    line_residuals_ = prepare(x, x * c, measured.tail(n - line_first_), line_first_);
  }
}

ParameterResampler::Residuals ParameterResampler::prepare(const Eigen::MatrixXd& columns,
                                                          const Eigen::VectorXd& fitted,
                                                          const Eigen::VectorXd& measured,
                                                          Eigen::Index first) const {
  // Gravity can be told from friction only where both directions were recorded.
  constexpr double least_own_share = 0.5;
  Residuals out;
  out.fitted = fitted;
  const Eigen::Index n = fitted.size();
  const auto projection = [](const Eigen::MatrixXd& x) {
    return statistics::OrthogonalColumns(x).basis();
  };
  Eigen::MatrixXd used = columns;
  Eigen::MatrixXd q = projection(columns);
  const Eigen::VectorXd gravity = gravity_.segment(first, n);
  const Eigen::VectorXd own = gravity - q * (q.transpose() * gravity);
  if (own.norm() > least_own_share * gravity.norm() && n > columns.cols() + 1) {
    Eigen::MatrixXd wider(n, columns.cols() + 1);
    wider << columns, gravity;
    used = wider;
    q = projection(wider);
  }
  const Eigen::VectorXd left = (measured - fitted) - q * (q.transpose() * (measured - fitted));
  out.scatter.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double share = 1 - q.row(i).squaredNorm();
    out.scatter(i) = left(i) / std::sqrt(std::max(share, 1e-6));
  }
  // Few runs decide some parameters: the scatter is known as badly as it is for the worst of them.
  std::vector<std::size_t> own_block(static_cast<std::size_t>(n));
  std::iota(own_block.begin(), own_block.end(), 0U);
  out.freedom =
      statistics::block_regression(used, left, own_block).freedom.head(columns.cols()).minCoeff();
  return out;
}

ParameterDraw ParameterResampler::draw(statistics::RandomStream& random, double gravity_shift_Nm,
                                       double q_peak_shift_rad, double gravity_Nm) const {
  ParameterDraw out;
  const auto redrawn = [&](const Residuals& residuals, Eigen::Index first) {
    const double scale = statistics::few_blocks_scale(random, residuals.freedom);
    Eigen::VectorXd y = residuals.fitted;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
      y(i) += scale * sign * residuals.scatter(i) + gravity_(first + i) * gravity_shift_Nm +
              angle_(first + i) * gravity_Nm * q_peak_shift_rad;
    }
    return y;
  };
  if (waiboer_.size() > 0) {
    const Eigen::VectorXd p = refit(points_, redrawn(waiboer_residuals_, 0), waiboer_);
    out.waiboer = {std::exp(p(0)), std::exp(p(1)), std::exp(p(2)), std::exp(p(3)),
                   1 - std::exp(p(4))};
  }
  if (line_solver_.size() > 0) {
    const Eigen::Vector2d c = line_solver_ * redrawn(line_residuals_, line_first_);
    out.line = {c(0), c(1)};
  }
  return out;
}

}  // namespace tribolog::method::intervals
