#include "method/hysteresis/position_mean.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

// Lines whose sines are nearly collinear at the positions would make the mean worse than omitting
// them.
constexpr double largest_condition = 30;
constexpr Eigen::Index fewest_spare = 2;
constexpr Eigen::Index fewest_for_harmonics = 6;
/// Smallest over largest singular value of the harmonics at evenly spread positions is 1/sqrt(2).
constexpr double evenly_spread = 0.5;

struct Positions {
  std::vector<statistics::Estimate> gravity_Nm;
  std::vector<double> angle_rad;  // ascending
};

/// Motor angles between which ripple changes by a quarter of a period.
double quarter_period_rad(const gravity::Ripple& ripple) {
  constexpr double periods_per_turn = 6;
  const double strongest = ripple.lines.empty() ? 0.0 : ripple.lines.front().periods_per_turn;
  return std::numbers::pi / 2 / std::max(periods_per_turn, strongest);
}

/// The plain mean, with the wider of the own intervals and of the scatter.
statistics::Estimate plain_mean(const std::vector<statistics::Estimate>& all,
                                const Statement& scatter) {
  if (all.size() == 1) return all.front();
  const auto n = static_cast<double>(all.size());
  double mean = 0;
  double own = 0;
  for (const statistics::Estimate& e : all) {
    mean += e.value / n;
    own += std::pow(e.half_width() / n, 2);
  }
  double squares = 0;
  for (const statistics::Estimate& e : all) squares += std::pow(e.value - mean, 2);
  const double between = statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n);
  return statistics::symmetric_estimate(mean, std::max(std::sqrt(own), between), scatter);
}

/// Sorted by angle, repeats of one position averaged.
Positions without_repeats(const std::vector<statistics::Estimate>& gravity_Nm,
                          const std::vector<double>& motor_angle_rad, double together_rad,
                          const Statement& scatter) {
  std::vector<std::size_t> order(gravity_Nm.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return motor_angle_rad[a] < motor_angle_rad[b];
  });
  Positions out;
  for (std::size_t first = 0; first < order.size();) {
    std::vector<statistics::Estimate> here;
    double angle = 0;
    std::size_t k = first;
    for (; k < order.size() &&
           motor_angle_rad[order[k]] - motor_angle_rad[order[first]] <= together_rad;
         ++k) {
      here.push_back(gravity_Nm[order[k]]);
      angle += motor_angle_rad[order[k]];
    }
    out.gravity_Nm.push_back(plain_mean(here, scatter));
    out.angle_rad.push_back(angle / static_cast<double>(here.size()));
    first = k;
  }
  return out;
}

/// Appends columns of cosine and sine of one more period.
Eigen::MatrixXd with_period(const Eigen::MatrixXd& x, const std::vector<double>& angle,
                            double periods_per_turn) {
  Eigen::MatrixXd wider(x.rows(), x.cols() + 2);
  wider.leftCols(x.cols()) = x;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const double phase = periods_per_turn * angle[static_cast<std::size_t>(i)];
    wider(i, x.cols()) = std::cos(phase);
    wider(i, x.cols() + 1) = std::sin(phase);
  }
  return wider;
}

/// Smallest singular value over the largest.
double evenness(const Eigen::MatrixXd& x) {
  const Eigen::VectorXd values = statistics::singular_values(x).values;
  return values(x.cols() - 1) / values(0);
}

/// Columns: 1, and cosine and sine of as many lines as the positions can separate; of harmonics
/// where no line is known.
Eigen::MatrixXd position_design(const std::vector<double>& angle, const gravity::Ripple& ripple) {
  const auto n = static_cast<Eigen::Index>(angle.size());
  Eigen::MatrixXd x = Eigen::MatrixXd::Ones(n, 1);
  for (const gravity::RippleLine& line : ripple.lines) {
    if (n - x.cols() - 2 < fewest_spare) break;
    const Eigen::MatrixXd wider = with_period(x, angle, line.periods_per_turn);
    if (evenness(wider) * largest_condition >= 1) x = wider;
  }
  if (!ripple.lines.empty() || n < fewest_for_harmonics) return x;
  Eigen::MatrixXd harmonics = x;
  for (Eigen::Index order = 1; order <= n / 2 - 2; ++order) {
    harmonics = with_period(harmonics, angle, static_cast<double>(order));
  }
  return evenness(harmonics) >= evenly_spread ? harmonics : x;
}

}  // namespace

double share_left_in_mean(const gravity::RippleLine& line,
                          const std::vector<double>& motor_angle_rad) {
  std::complex<double> sum = 0;
  for (const double angle : motor_angle_rad) sum += std::polar(1.0, line.periods_per_turn * angle);
  return std::abs(sum) / static_cast<double>(motor_angle_rad.size());
}

gravity::CogSweepResult of_motor_turn(gravity::CogSweepResult sweep, double gear_ratio) {
  constexpr double fewest_periods = 10;
  const double turns = gear_ratio * (sweep.highest_rad - sweep.lowest_rad) / (2 * std::numbers::pi);
  std::vector<gravity::RippleLine>& lines = sweep.friction_of_angle.lines;
  lines.erase(std::remove_if(lines.begin(), lines.end(),
                             [&](const gravity::RippleLine& line) {
                               return line.periods_per_turn * turns <= fewest_periods;
                             }),
              lines.end());
  sweep.friction_of_angle.rest_Nm = 0;
  sweep.friction_by_angle_Nm = sweep.friction_of_angle.sd_Nm();
  return sweep;
}

std::vector<std::size_t> position_numbers(const std::vector<double>& motor_angle_rad) {
  constexpr double one_position_rad = 0.13;
  std::vector<std::size_t> order(motor_angle_rad.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return motor_angle_rad[a] < motor_angle_rad[b];
  });
  std::vector<std::size_t> numbers(motor_angle_rad.size());
  std::size_t number = 0;
  double first = order.empty() ? 0 : motor_angle_rad[order.front()];
  for (const std::size_t i : order) {
    if (motor_angle_rad[i] - first > one_position_rad) {
      ++number;
      first = motor_angle_rad[i];
    }
    numbers[i] = number;
  }
  return numbers;
}

std::size_t distinct_positions(std::vector<double> motor_angle_rad, const gravity::Ripple& ripple) {
  const double apart = quarter_period_rad(ripple);
  std::sort(motor_angle_rad.begin(), motor_angle_rad.end());
  std::size_t count = 0;
  double last = 0;
  for (const double angle : motor_angle_rad) {
    if (count > 0 && angle - last < apart) continue;
    last = angle;
    ++count;
  }
  return count;
}

PositionMean mean_over_positions(const std::vector<statistics::Estimate>& gravity_Nm,
                                 const std::vector<double>& motor_angle_rad,
                                 const gravity::Ripple& ripple, const Statement& scatter) {
  if (gravity_Nm.empty() || gravity_Nm.size() != motor_angle_rad.size()) {
    throw std::invalid_argument("angles missing");
  }
  // Repeats return to an angle within a fraction of what changes the ripple.
  constexpr double together = 0.1;
  const Positions at =
      without_repeats(gravity_Nm, motor_angle_rad, together * quarter_period_rad(ripple), scatter);
  PositionMean out;
  if (distinct_positions(at.angle_rad, ripple) < fewest_positions) {
    out.gravity_Nm = plain_mean(at.gravity_Nm, scatter);
    return out;
  }
  const Eigen::MatrixXd x = position_design(at.angle_rad, ripple);
  Eigen::VectorXd y(x.rows());
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    y(i) = at.gravity_Nm[static_cast<std::size_t>(i)].value;
  }
  const Eigen::MatrixXd inverse = statistics::inverse_normal(x);
  const Eigen::VectorXd c = inverse * (x.transpose() * y);
  const Eigen::VectorXd residuals = y - x * c;
  out.residuals_Nm.assign(residuals.begin(), residuals.end());
  out.freedom = static_cast<double>(x.rows() - x.cols());
  const double variance = residuals.squaredNorm() / out.freedom * inverse(0, 0);
  out.gravity_Nm = statistics::symmetric_estimate(
      c(0), statistics::student_t_975(out.freedom) * std::sqrt(variance),
      x.cols() > 1 ? Statement{"interval.scatter_of_positions_about_ripple"}
                   : Statement{"interval.scatter_of_positions"});
  return out;
}

}  // namespace tribolog::method::hysteresis
