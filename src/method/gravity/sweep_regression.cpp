#include "method/gravity/sweep_regression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::gravity {

double white_torque_variance(const motion::Sweep& sweep) {
  const motion::SweepSamples& samples = sweep.samples;
  std::vector<double> third;
  for (std::size_t i = 3; i < samples.size(); ++i) {
    const bool neighbours = samples.recording[i - 3] == samples.recording[i] &&
                            samples.index[i - 3] + 3 == samples.index[i];
    if (!neighbours) continue;
    const joint::Recording& r = *sweep.recordings[samples.recording[i]];
    third.push_back(statistics::third_difference(&r.torque_Nm[samples.index[i] - 3]));
  }
  return statistics::white_variance(third);
}

double torque_ripple_Nm(double residual_sd_Nm, double white_variance) {
  constexpr double least_share = 0.05;
  const double rest = residual_sd_Nm * residual_sd_Nm - white_variance;
  return rest > least_share * white_variance ? std::sqrt(rest) : 0.0;
}

SweepDesign sweep_design(const motion::Sweep& sweep, Eigen::Index gravity_columns) {
  const motion::SweepSamples& samples = sweep.samples;
  SweepDesign d;
  const auto rows = static_cast<Eigen::Index>(samples.size());
  const bool both = samples.both_directions();
  d.offset_of_sample.resize(samples.size(), 0);
  d.offset_count = 1;
  if (samples.constant_speed) {
    // One offset for each stroke direction of each recording: its own friction.
    std::vector<std::pair<std::size_t, double>> seen;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const std::pair key{samples.recording[i], samples.direction[i]};
      const auto at = std::find(seen.begin(), seen.end(), key);
      d.offset_of_sample[i] = static_cast<std::size_t>(at - seen.begin());
      if (at == seen.end()) seen.push_back(key);
    }
    d.offset_count = static_cast<Eigen::Index>(seen.size());
  }
  d.offsets = gravity_columns;
  Eigen::Index next = gravity_columns + d.offset_count;
  if (!samples.constant_speed) {
    if (both) d.direction = next++;
    d.speed = next++;
    d.acceleration = next++;
  }
  const Eigen::Index drift = both ? next++ : -1;
  d.x = Eigen::MatrixXd::Zero(rows, next);
  d.y.resize(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    d.y(row) = sweep.torque_Nm(i);
    d.x(row, d.offsets + static_cast<Eigen::Index>(d.offset_of_sample[i])) = 1;
    if (drift >= 0) {
      const std::vector<double>& t_s = sweep.recordings[samples.recording[i]]->t_s;
      const double half_s = (t_s.back() - t_s.front()) / 2;
      d.x(row, drift) = (t_s[samples.index[i]] - t_s.front()) / half_s - 1;
    }
    if (d.direction >= 0) d.x(row, d.direction) = samples.direction[i];
    if (d.speed >= 0) d.x(row, d.speed) = samples.speed_rad_s[i];
    if (d.acceleration >= 0) d.x(row, d.acceleration) = samples.acceleration_rad_s2[i];
  }
  return d;
}

SweepGravityFit fit_amplitude_and_angle(const motion::Sweep& sweep, SweepDesign& d, double middle,
                                        const std::vector<std::size_t>& blocks) {
  const motion::SweepSamples& samples = sweep.samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = sweep.q_rad(i) - middle;
    // 1 - cos q as 2 sin^2(q/2): no cancellation in a sweep of one degree.
    const double half = std::sin(q / 2);
    d.x(static_cast<Eigen::Index>(i), 0) = -2 * half * half;
    d.x(static_cast<Eigen::Index>(i), 1) = std::sin(q);
  }
  SweepGravityFit fit;
  fit.regression = statistics::block_regression(d.x, d.y, blocks);
  const double b = fit.regression.coefficients(0);
  const double c = fit.regression.coefficients(1);
  const auto& v = fit.regression.covariance;
  const double g = std::hypot(b, c);
  const double t = statistics::student_t_975(fit.regression.freedom.head<2>().minCoeff());
  const Eigen::Vector2d bc(b, c);
  fit.evidence = statistics::mahalanobis_square(v.topLeftCorner(2, 2), bc);
  const double var_q = (c * c * v(0, 0) - 2 * b * c * v(0, 1) + b * b * v(1, 1)) / std::pow(g, 4);
  const double var_g = (b * b * v(0, 0) + 2 * b * c * v(0, 1) + c * c * v(1, 1)) / (g * g);
  constexpr Code method{"interval.least_squares_blocks"};
  fit.q_peak_rad = statistics::symmetric_estimate(middle + std::atan2(c, b),
                                                  t * std::sqrt(std::max(0.0, var_q)), method);
  fit.gravity_Nm = statistics::symmetric_estimate(g, t * std::sqrt(std::max(0.0, var_g)), method);
  // The offsets were fitted against cos q - 1: what belongs to gravity is taken out of them.
  for (Eigen::Index k = 0; k < d.offset_count; ++k) fit.regression.coefficients(d.offsets + k) -= b;
  return fit;
}

SweepGravityFit fit_angle(const motion::Sweep& sweep, SweepDesign& d, double start,
                          double gravity_Nm, const std::vector<std::size_t>& blocks) {
  const motion::SweepSamples& samples = sweep.samples;
  const Eigen::VectorXd torque = d.y;
  double q_peak = start;
  SweepGravityFit fit;
  for (int iteration = 0; iteration < 20; ++iteration) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double from_peak = sweep.q_rad(i) - q_peak;
      const auto row = static_cast<Eigen::Index>(i);
      d.y(row) = torque(row) - gravity_Nm * std::cos(from_peak);
      d.x(row, 0) = gravity_Nm * std::sin(from_peak);
    }
    fit.regression = statistics::block_regression(d.x, d.y, blocks);
    const double step = std::clamp(fit.regression.coefficients(0), -0.5, 0.5);
    q_peak += step;
    if (std::abs(step) < 1e-13) break;
  }
  fit.q_peak_rad = statistics::symmetric_estimate(q_peak, fit.regression.half_width(0),
                                                  {"interval.least_squares_known_amplitude"});
  fit.gravity_Nm =
      statistics::symmetric_estimate(gravity_Nm, 0, {"interval.least_squares_known_amplitude"});
  fit.evidence = std::numeric_limits<double>::infinity();  // it is known
  return fit;
}

Eigen::VectorXd rough_residuals(const motion::Sweep& sweep, const Eigen::VectorXd& residuals,
                                const CogSweepResult& result, double q_peak_rad) {
  constexpr Eigen::Index modes = 5;                // of half a period each
  constexpr std::array knots{0.2, 0.4, 0.6, 0.8};  // quantiles of the speed
  const motion::SweepSamples& samples = sweep.samples;
  std::vector<double> speeds;
  for (const double speed : samples.speed_rad_s) speeds.push_back(std::abs(speed));
  std::vector<double> bends;
  for (const double knot : knots) {
    if (!samples.constant_speed) bends.push_back(statistics::value_at_share(speeds, knot));
  }
  const auto bend_count = static_cast<Eigen::Index>(bends.size());
  Eigen::MatrixXd x(residuals.size(), modes + 1 + bend_count);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double place =
        (sweep.q_rad(i) - result.lowest_rad) / (result.highest_rad - result.lowest_rad);
    const auto row = static_cast<Eigen::Index>(i);
    for (Eigen::Index k = 0; k < modes; ++k) {
      x(row, k) = std::cos(std::numbers::pi * static_cast<double>(k + 1) * place);
    }
    x(row, modes) = samples.direction[i] * std::abs(std::cos(sweep.q_rad(i) - q_peak_rad));
    for (Eigen::Index k = 0; k < bend_count; ++k) {
      x(row, modes + 1 + k) =
          samples.direction[i] * std::max(0.0, speeds[i] - bends[static_cast<std::size_t>(k)]);
    }
  }
  return residuals - x * statistics::least_squares(x, residuals);
}

}  // namespace tribolog::method::gravity
