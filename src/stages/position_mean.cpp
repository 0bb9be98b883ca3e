#include "stages/position_mean.h"

#include <cmath>
#include <complex>
#include <stdexcept>

#include <Eigen/Dense>

#include "stages/student_t.h"

namespace tribolog {
namespace {

// Lines whose sines look alike at the positions would make the mean worse than leaving them.
constexpr double largest_condition = 30;
constexpr Eigen::Index fewest_spare = 2;

/// Columns: 1, and cosine and sine of as many lines as the positions can tell apart.
Eigen::MatrixXd position_design(const std::vector<double>& angle, const Ripple& ripple) {
  const auto n = static_cast<Eigen::Index>(angle.size());
  Eigen::MatrixXd x = Eigen::MatrixXd::Ones(n, 1);
  for (const RippleLine& line : ripple.lines) {
    if (n - x.cols() - 2 < fewest_spare) break;
    Eigen::MatrixXd wider(n, x.cols() + 2);
    wider.leftCols(x.cols()) = x;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double phase = line.periods_per_turn * angle[static_cast<std::size_t>(i)];
      wider(i, x.cols()) = std::cos(phase);
      wider(i, x.cols() + 1) = std::sin(phase);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(wider);
    if (svd.singularValues()(wider.cols() - 1) * largest_condition < svd.singularValues()(0)) {
      continue;
    }
    x = wider;
  }
  return x;
}

}  // namespace

double share_left_in_mean(const RippleLine& line, const std::vector<double>& motor_angle_rad) {
  std::complex<double> sum = 0;
  for (const double angle : motor_angle_rad) sum += std::polar(1.0, line.periods_per_turn * angle);
  return std::abs(sum) / static_cast<double>(motor_angle_rad.size());
}

PositionMean mean_over_positions(const std::vector<double>& gravity_Nm,
                                 const std::vector<double>& motor_angle_rad, const Ripple& ripple) {
  if (gravity_Nm.size() < 3 || gravity_Nm.size() != motor_angle_rad.size()) {
    throw std::invalid_argument("a mean over positions needs at least three, each with its angle");
  }
  const Eigen::MatrixXd x = position_design(motor_angle_rad, ripple);
  const auto n = static_cast<Eigen::Index>(gravity_Nm.size());
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(gravity_Nm.data(), n);
  const Eigen::MatrixXd inverse = (x.transpose() * x).inverse();
  const Eigen::VectorXd c = inverse * (x.transpose() * y);
  PositionMean out;
  out.freedom = static_cast<double>(n - x.cols());
  const double variance = (y - x * c).squaredNorm() / out.freedom * inverse(0, 0);
  out.gravity_Nm = symmetric_estimate(
      c(0), student_t_975(out.freedom) * std::sqrt(variance),
      x.cols() > 1 ? "scatter of the positions about the ripple" : "scatter of the positions");
  return out;
}

}  // namespace tribolog
