#include "method/gravity/sweep_regression.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "statistics/student_t.h"

namespace tribolog {

double angle_of(const std::vector<const Recording*>& recordings, const SweepSamples& samples,
                std::size_t i) {
  return recordings[samples.recording[i]]->q_rad[samples.index[i]];
}

SweepDesign sweep_design(const std::vector<const Recording*>& recordings,
                         const SweepSamples& samples, Eigen::Index gravity_columns) {
  SweepDesign d;
  const auto rows = static_cast<Eigen::Index>(samples.size());
  const bool both = samples.both_directions();
  d.offset_of_sample.resize(samples.size(), 0);
  d.offset_count = 1;
  Eigen::Index extra = 0;
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
  } else {
    extra = both ? 3 : 2;  // direction (with both), speed, acceleration
  }
  d.offsets = gravity_columns;
  d.x = Eigen::MatrixXd::Zero(rows, gravity_columns + d.offset_count + extra);
  d.y.resize(rows);
  if (!samples.constant_speed) {
    Eigen::Index next = gravity_columns + d.offset_count;
    if (both) d.direction = next++;
    d.speed = next++;
    d.acceleration = next;
  }
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    d.y(row) = recordings[samples.recording[i]]->torque_Nm[samples.index[i]];
    d.x(row, d.offsets + static_cast<Eigen::Index>(d.offset_of_sample[i])) = 1;
    if (d.direction >= 0) d.x(row, d.direction) = samples.direction[i];
    if (d.speed >= 0) d.x(row, d.speed) = samples.speed_rad_s[i];
    if (d.acceleration >= 0) d.x(row, d.acceleration) = samples.acceleration_rad_s2[i];
  }
  return d;
}

SweepGravityFit fit_amplitude_and_angle(const std::vector<const Recording*>& recordings,
                                        const SweepSamples& samples, SweepDesign& d, double middle,
                                        const std::vector<std::size_t>& blocks) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = angle_of(recordings, samples, i) - middle;
    // 1 - cos q as 2 sin^2(q/2): no cancellation in a sweep of one degree.
    const double half = std::sin(q / 2);
    d.x(static_cast<Eigen::Index>(i), 0) = -2 * half * half;
    d.x(static_cast<Eigen::Index>(i), 1) = std::sin(q);
  }
  SweepGravityFit fit;
  fit.regression = block_regression(d.x, d.y, blocks);
  const double b = fit.regression.coefficients(0);
  const double c = fit.regression.coefficients(1);
  const auto& v = fit.regression.covariance;
  const double g = std::hypot(b, c);
  fit.freedom = fit.regression.freedom.head<2>().minCoeff();
  const double t = student_t_975(fit.freedom);
  const Eigen::Vector2d bc(b, c);
  const Eigen::Matrix2d v2 = v.topLeftCorner<2, 2>();
  fit.evidence = bc.dot(v2.ldlt().solve(bc));
  const double var_q = (c * c * v(0, 0) - 2 * b * c * v(0, 1) + b * b * v(1, 1)) / std::pow(g, 4);
  const double var_g = (b * b * v(0, 0) + 2 * b * c * v(0, 1) + c * c * v(1, 1)) / (g * g);
  const char* method = "least squares, blocks of neighbouring samples";
  fit.q_peak_rad =
      symmetric_estimate(middle + std::atan2(c, b), t * std::sqrt(std::max(0.0, var_q)), method);
  fit.gravity_Nm = symmetric_estimate(g, t * std::sqrt(std::max(0.0, var_g)), method);
  const auto& shifts = fit.regression.block_shifts;
  fit.block_shifts.resize(2, shifts.cols());
  fit.block_shifts.row(0) = (b * shifts.row(1) - c * shifts.row(0)) / (g * g);
  fit.block_shifts.row(1) = (b * shifts.row(0) + c * shifts.row(1)) / g;
  // The offsets were fitted against cos q - 1: what belongs to gravity is taken out of them.
  for (Eigen::Index k = 0; k < d.offset_count; ++k) {
    fit.regression.coefficients(d.offsets + k) -= b;
  }
  return fit;
}

SweepGravityFit fit_angle(const std::vector<const Recording*>& recordings,
                          const SweepSamples& samples, SweepDesign& d, double middle,
                          const Estimate& gravity, const std::vector<std::size_t>& blocks) {
  const Eigen::VectorXd torque = d.y;
  double q_peak = middle;
  SweepGravityFit fit;
  for (int iteration = 0; iteration < 20; ++iteration) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double q = angle_of(recordings, samples, i) - q_peak;
      const auto row = static_cast<Eigen::Index>(i);
      d.y(row) = torque(row) - gravity.value * std::cos(q);
      d.x(row, 0) = gravity.value * std::sin(q);
    }
    fit.regression = block_regression(d.x, d.y, blocks);
    const double step = std::clamp(fit.regression.coefficients(0), -0.5, 0.5);
    q_peak += step;
    if (std::abs(step) < 1e-13) break;
  }
  const double from_noise = fit.regression.half_width(0);
  // An amplitude off by a share shifts the angle by that share of its distance from the middle.
  const double from_amplitude = (q_peak - middle) * gravity.half_width() / gravity.value;
  fit.q_peak_rad = symmetric_estimate(q_peak, std::hypot(from_noise, from_amplitude),
                                      "least squares with the amplitude of the rough sweep");
  fit.gravity_Nm = gravity;
  fit.freedom = fit.regression.freedom(0);
  fit.block_shifts = Eigen::MatrixXd::Zero(2, fit.regression.block_shifts.cols());
  fit.block_shifts.row(0) = fit.regression.block_shifts.row(0);
  fit.evidence = std::numeric_limits<double>::infinity();  // the rough sweep has shown it
  return fit;
}

Eigen::VectorXd effect_on_coefficients(const SweepDesign& d, const Eigen::VectorXd& extra_Nm) {
  const Eigen::VectorXd scale =
      d.x.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? 1 / n : 1.0; });
  const Eigen::MatrixXd normal = scale.asDiagonal() * (d.x.transpose() * d.x) * scale.asDiagonal();
  const Eigen::VectorXd right = scale.asDiagonal() * (d.x.transpose() * extra_Nm);
  return scale.asDiagonal() * normal.ldlt().solve(right);
}

}  // namespace tribolog
