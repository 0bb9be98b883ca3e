#include "method/gravity/sweep_regression.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"
#include "statistics/sampled_signal.h"
#include "statistics/wandering_noise.h"

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

double link_from_peak_rad(double x, double twist_rad) {
  if (twist_rad == 0) return x;
  double link = x;
  for (int k = 0; k < 30; ++k) {
    const double step = (link - x + twist_rad * std::cos(link)) / (1 - twist_rad * std::sin(link));
    link -= step;
    if (std::abs(step) < 1e-15) break;
  }
  return link;
}

SweepDesign sweep_design(const motion::Sweep& sweep, Eigen::Index gravity_columns, bool with_twist,
                         const std::optional<double>& inertia_at_joint) {
  const motion::SweepSamples& samples = sweep.samples;
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
    d.inertia_at_joint = inertia_at_joint;
    // Direction (with both), speed, acceleration.
    extra = (both ? 2 : 1) + (inertia_at_joint ? 0 : 1);
  }
  if (both) d.drift = gravity_columns + d.offset_count + extra++;
  if (with_twist) d.twist = gravity_columns + d.offset_count + extra++;
  d.offsets = gravity_columns;
  d.x = Eigen::MatrixXd::Zero(rows, gravity_columns + d.offset_count + extra);
  d.y.resize(rows);
  if (!samples.constant_speed) {
    Eigen::Index next = gravity_columns + d.offset_count;
    if (both) d.direction = next++;
    d.speed = next++;
    if (!d.inertia_at_joint) d.acceleration = next;
  }
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto i = static_cast<std::size_t>(row);
    d.y(row) = sweep.torque_Nm(i);
    if (d.inertia_at_joint) d.y(row) -= *d.inertia_at_joint * samples.acceleration_rad_s2[i];
    d.x(row, d.offsets + static_cast<Eigen::Index>(d.offset_of_sample[i])) = 1;
    if (d.drift >= 0) {
      const std::vector<double>& t_s = sweep.recordings[samples.recording[i]]->t_s;
      const double half_s = (t_s.back() - t_s.front()) / 2;
      d.x(row, d.drift) = (t_s[samples.index[i]] - t_s.front()) / half_s - 1;
    }
    if (d.direction >= 0) d.x(row, d.direction) = samples.direction[i];
    if (d.speed >= 0) d.x(row, d.speed) = samples.speed_rad_s[i];
    if (d.acceleration >= 0) d.x(row, d.acceleration) = samples.acceleration_rad_s2[i];
  }
  return d;
}

namespace {

/// What a twist adds to the torque, per unit of twist and of gravity torque.
void fill_twist_column(const motion::Sweep& sweep, double q_peak, double twist, SweepDesign& d) {
  constexpr double smallest = 1e-6;  // below it, the limit
  constexpr double largest = 0.1;    // no gear gives more: noise alone says so
  twist = std::clamp(twist, -largest, largest);
  for (std::size_t i = 0; i < sweep.samples.size(); ++i) {
    const double x = sweep.q_rad(i) - q_peak;
    d.x(static_cast<Eigen::Index>(i), d.twist) =
        std::abs(twist) < smallest ? std::sin(x) * std::cos(x)
                                   : (std::cos(link_from_peak_rad(x, twist)) - std::cos(x)) / twist;
  }
}

/// Iterates: the column of the twist depends on angle and twist themselves.
void settle_twist_column(const motion::Sweep& sweep, double middle, SweepDesign& d) {
  double q_peak = middle;
  double twist = 0;
  for (int iteration = 0; iteration < 12; ++iteration) {
    fill_twist_column(sweep, q_peak, twist, d);
    const Eigen::VectorXd c = effect_on_coefficients(d, d.y);
    const double next = middle + std::atan2(c(1), c(0));
    const double step = next - q_peak;
    q_peak = next;
    twist = c(d.twist) / std::max(std::hypot(c(0), c(1)), 1e-300);
    constexpr double settled_rad = 1e-9;
    if (std::abs(step) < settled_rad) break;
  }
}

}  // namespace

namespace {

/// About forty blocks of neighbours in time, or whole strokes where there are more of them.
statistics::BlockMeans blocks_in_time(const motion::Sweep& sweep, const SweepDesign& d,
                                      const Eigen::VectorXd& residuals) {
  constexpr std::size_t in_all = 40;
  const motion::SweepSamples& samples = sweep.samples;
  const std::size_t strokes = samples.stroke.back() + 1;
  std::vector<std::size_t> block =
      statistics::equal_blocks(samples.stroke, std::max<std::size_t>(1, in_all / strokes));
  if (block.back() >= 2 * in_all) {
    const std::size_t together = block.back() / in_all;
    for (std::size_t& b : block) b /= together;
  }
  const auto count = static_cast<Eigen::Index>(block.back() + 1);
  const Eigen::Index columns = d.x.cols();
  statistics::BlockMeans out{Eigen::MatrixXd::Zero(count, columns),
                             Eigen::VectorXd::Zero(count),
                             Eigen::VectorXd::Zero(count),
                             Eigen::VectorXd::Zero(count),
                             std::vector<std::size_t>(block.back() + 1),
                             {}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto b = static_cast<Eigen::Index>(block[i]);
    const auto row = static_cast<Eigen::Index>(i);
    out.columns.row(b) += d.x.row(row);
    out.residuals(b) += residuals(row);
    out.samples(b) += 1;
    out.time_s(b) += sweep.recordings[samples.recording[i]]->t_s[samples.index[i]];
    out.recording[block[i]] = samples.recording[i];
  }
  const Eigen::VectorXd scale =
      d.x.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? 1 / n : 1.0; });
  const Eigen::MatrixXd normal = scale.asDiagonal() * (d.x.transpose() * d.x) * scale.asDiagonal();
  out.effects = scale.asDiagonal() *
                statistics::solve_normal(normal, scale.asDiagonal() * out.columns.transpose());
  const Eigen::VectorXd share = out.samples.cwiseInverse();
  out.columns = share.asDiagonal() * out.columns;
  out.residuals.array() *= share.array();
  out.time_s.array() *= share.array();
  return out;
}

/// Where the torque wanders from block to block, the resulting covariance replaces that of the
/// blocks if it is larger.
void hold_wandering(const motion::Sweep& sweep, const SweepDesign& d,
                    statistics::BlockRegression& regression) {
  const auto wandering =
      statistics::wandering_noise(blocks_in_time(sweep, d, regression.residuals));
  if (!wandering) return;
  const Eigen::MatrixXd covariance = wandering->shifts * wandering->shifts.transpose();
  const Eigen::Vector2d more =
      covariance.diagonal().head<2>().cwiseQuotient(regression.covariance.diagonal().head<2>());
  if (!(more.sum() > 2)) return;
  regression.block_shifts = wandering->shifts;
  regression.covariance = covariance;
}

}  // namespace

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
  if (d.twist >= 0) settle_twist_column(sweep, middle, d);
  SweepGravityFit fit;
  fit.regression = statistics::block_regression(d.x, d.y, blocks);
  hold_wandering(sweep, d, fit.regression);
  const double b = fit.regression.coefficients(0);
  const double c = fit.regression.coefficients(1);
  const auto& v = fit.regression.covariance;
  const double g = std::hypot(b, c);
  fit.freedom = fit.regression.freedom.head<2>().minCoeff();
  const double t = statistics::student_t_975(fit.freedom);
  const Eigen::Vector2d bc(b, c);
  fit.evidence = statistics::mahalanobis_square(v.topLeftCorner(2, 2), bc);
  const double var_q = (c * c * v(0, 0) - 2 * b * c * v(0, 1) + b * b * v(1, 1)) / std::pow(g, 4);
  const double var_g = (b * b * v(0, 0) + 2 * b * c * v(0, 1) + c * c * v(1, 1)) / (g * g);
  constexpr Code method{"interval.least_squares_blocks"};
  fit.q_peak_rad = statistics::symmetric_estimate(middle + std::atan2(c, b),
                                                  t * std::sqrt(std::max(0.0, var_q)), method);
  fit.gravity_Nm = statistics::symmetric_estimate(g, t * std::sqrt(std::max(0.0, var_g)), method);
  const auto& shifts = fit.regression.block_shifts;
  fit.block_shifts = Eigen::MatrixXd::Zero(3, shifts.cols());
  fit.block_shifts.row(0) = (b * shifts.row(1) - c * shifts.row(0)) / (g * g);
  fit.block_shifts.row(1) = (b * shifts.row(0) + c * shifts.row(1)) / g;
  if (d.twist >= 0) {
    const double twist = fit.regression.coefficients(d.twist) / g;
    fit.block_shifts.row(2) = (shifts.row(d.twist) - twist * fit.block_shifts.row(1)) / g;
    const double freedom = std::min(fit.freedom, fit.regression.freedom(d.twist));
    fit.twist_rad = statistics::symmetric_estimate(
        twist, statistics::student_t_975(freedom) * fit.block_shifts.row(2).norm(), method);
  }
  // The offsets were fitted against cos q - 1: what belongs to gravity is taken out of them.
  for (Eigen::Index k = 0; k < d.offset_count; ++k) {
    fit.regression.coefficients(d.offsets + k) -= b;
  }
  return fit;
}

SweepGravityFit fit_angle(const motion::Sweep& sweep, SweepDesign& d, double start,
                          const statistics::Estimate& gravity, double twist_rad,
                          const std::vector<std::size_t>& blocks) {
  const motion::SweepSamples& samples = sweep.samples;
  const Eigen::VectorXd torque = d.y;
  double q_peak = start;
  SweepGravityFit fit;
  for (int iteration = 0; iteration < 20; ++iteration) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double link = link_from_peak_rad(sweep.q_rad(i) - q_peak, twist_rad);
      const auto row = static_cast<Eigen::Index>(i);
      d.y(row) = torque(row) - gravity.value * std::cos(link);
      d.x(row, 0) = gravity.value * std::sin(link) / (1 - twist_rad * std::sin(link));
    }
    fit.regression = statistics::block_regression(d.x, d.y, blocks);
    const double step = std::clamp(fit.regression.coefficients(0), -0.5, 0.5);
    q_peak += step;
    if (std::abs(step) < 1e-13) break;
  }
  const double from_noise = fit.regression.half_width(0);
  // An amplitude off by a share shifts the angle by that share of its distance from the start.
  const double from_amplitude = (q_peak - start) * gravity.half_width() / gravity.value;
  fit.q_peak_rad = statistics::symmetric_estimate(q_peak, std::hypot(from_noise, from_amplitude),
                                                  {"interval.least_squares_known_amplitude"});
  fit.gravity_Nm = gravity;
  fit.freedom = fit.regression.freedom(0);
  fit.block_shifts = Eigen::MatrixXd::Zero(3, fit.regression.block_shifts.cols());
  fit.block_shifts.row(0) = fit.regression.block_shifts.row(0);
  fit.evidence = std::numeric_limits<double>::infinity();  // the rough sweep has shown it
  return fit;
}

Eigen::VectorXd effect_on_coefficients(const SweepDesign& d, const Eigen::VectorXd& extra_Nm) {
  const Eigen::VectorXd scale =
      d.x.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? 1 / n : 1.0; });
  const Eigen::MatrixXd normal = scale.asDiagonal() * (d.x.transpose() * d.x) * scale.asDiagonal();
  const Eigen::VectorXd right = scale.asDiagonal() * (d.x.transpose() * extra_Nm);
  return scale.asDiagonal() * statistics::solve_normal(normal, right);
}

GravityShift effect_on_gravity(const motion::Sweep& sweep, const CogSweepResult& found,
                               bool amplitude_known, const Eigen::VectorXd& extra_Nm) {
  SweepDesign design = sweep_design(sweep, amplitude_known ? 1 : 2);
  const double g = found.gravity_Nm.value;
  for (std::size_t i = 0; i < sweep.samples.size(); ++i) {
    const double q = sweep.q_rad(i) - found.q_peak_rad.value;
    const auto row = static_cast<Eigen::Index>(i);
    design.x(row, 0) = amplitude_known ? g * std::sin(q) : std::cos(q);
    if (!amplitude_known) design.x(row, 1) = std::sin(q);
  }
  const Eigen::VectorXd effect = effect_on_coefficients(design, extra_Nm);
  if (amplitude_known) return {effect(0), 0};
  return {effect(1) / g, effect(0)};
}

}  // namespace tribolog::method::gravity
