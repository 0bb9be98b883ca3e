#include "stages/gravity_at_positions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/Dense>

#include "stages/student_t.h"

namespace tribolog {
namespace {

constexpr Eigen::Index fewest_for_harmonics = 6;
/// Smallest over largest singular value of a design of evenly spread positions is 1/sqrt(2).
constexpr double evenly_spread = 0.5;

/// The constant of a harmonic series in the motor's angle, with its standard error; absent where
/// positions are too few or lie together.
std::optional<Estimate> beside_ripple(const std::vector<Estimate>& gravity_Nm,
                                      const std::vector<double>& centres_rad, double gear_ratio) {
  const auto n = static_cast<Eigen::Index>(gravity_Nm.size());
  if (n < fewest_for_harmonics) return std::nullopt;
  const Eigen::Index orders = n / 2 - 2;
  Eigen::MatrixXd x(n, 1 + 2 * orders);
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double motor = gear_ratio * centres_rad[at];
    x(i, 0) = 1;
    for (Eigen::Index k = 1; k <= orders; ++k) {
      x(i, 2 * k - 1) = std::cos(static_cast<double>(k) * motor);
      x(i, 2 * k) = std::sin(static_cast<double>(k) * motor);
    }
    y(i) = gravity_Nm[at].value;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(x, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const auto& s = svd.singularValues();
  if (s(s.size() - 1) < evenly_spread * s(0)) return std::nullopt;
  const Eigen::VectorXd c = svd.solve(y);
  const auto freedom = static_cast<double>(n - x.cols());
  const double variance = (y - x * c).squaredNorm() / freedom;
  const double gain = svd.matrixV().row(0).cwiseQuotient(s.transpose()).squaredNorm();
  return symmetric_estimate(c(0), student_t_975(freedom) * std::sqrt(variance * gain),
                            "scatter of the recordings about their ripple");
}

}  // namespace

std::size_t distinct_positions(std::vector<double> centres_rad, double gear_ratio) {
  constexpr double apart_turns = 1.0 / 24;
  const double apart_rad = apart_turns * 2 * std::numbers::pi / gear_ratio;
  std::sort(centres_rad.begin(), centres_rad.end());
  std::size_t count = 0;
  double last = 0;
  for (const double centre : centres_rad) {
    if (count > 0 && centre - last < apart_rad) continue;
    last = centre;
    ++count;
  }
  return count;
}

Estimate combined_over_recordings(const std::vector<Estimate>& gravity_Nm,
                                  const std::vector<double>& centres_rad, double gear_ratio,
                                  const std::string& from_one_source) {
  if (gravity_Nm.empty() || gravity_Nm.size() != centres_rad.size()) {
    throw std::invalid_argument("no recordings to combine, or not one angle of each");
  }
  if (gravity_Nm.size() == 1) return gravity_Nm.front();
  if (const auto e = beside_ripple(gravity_Nm, centres_rad, gear_ratio)) return *e;
  const auto n = static_cast<double>(gravity_Nm.size());
  double mean = 0;
  double own = 0;
  for (const Estimate& e : gravity_Nm) {
    mean += e.value / n;
    own += std::pow(e.half_width() / n, 2);
  }
  double squares = 0;
  for (const Estimate& e : gravity_Nm) squares += std::pow(e.value - mean, 2);
  const double between = student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n);
  if (gravity_Nm.size() >= fewest_positions) {
    return symmetric_estimate(mean, between, "scatter of the recordings");
  }
  return symmetric_estimate(mean, std::max(std::sqrt(own), between),
                            "scatter of the " + from_one_source + " and of the recordings");
}

Estimate with_ripple(Estimate torque, double ripple_Nm) {
  if (!(ripple_Nm > 0)) return torque;
  constexpr double normal_975 = 1.96;
  return symmetric_estimate(torque.value, std::hypot(torque.half_width(), normal_975 * ripple_Nm),
                            torque.method + ", widened by the ripple that the sweep shows");
}

}  // namespace tribolog
