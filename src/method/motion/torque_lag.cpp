#include "method/motion/torque_lag.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "statistics/block_regression.h"
#include "statistics/distributions.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::motion {
namespace {

/// The angle about a sample, by a polynomial of fourth order over its neighbours.
struct LocalMotion {
  double speed{}, acceleration{}, jerk{}, snap{};
};

constexpr int order = 4;

/// Weights of equally spaced neighbours for the first four derivatives.
class DerivativeWeights {
 public:
  DerivativeWeights(std::size_t half, double dt) : half_(static_cast<Eigen::Index>(half)) {
    const Eigen::Index size = 2 * half_ + 1;
    Eigen::MatrixXd x(size, order + 1);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double s = static_cast<double>(i - half_) / static_cast<double>(half_);
      x(i, 0) = 1;
      for (int k = 1; k <= order; ++k) x(i, k) = x(i, k - 1) * s;
    }
    weights_ = (x.transpose() * x).ldlt().solve(x.transpose()).bottomRows(order);
    double scale = 1;
    for (int k = 0; k < order; ++k) {
      scale *= (k + 1) / (static_cast<double>(half_) * dt);
      weights_.row(k) *= scale;
    }
  }
  [[nodiscard]] LocalMotion at(const std::vector<double>& q, std::size_t i) const {
    const Eigen::Map<const Eigen::VectorXd> near(&q[i - static_cast<std::size_t>(half_)],
                                                 2 * half_ + 1);
    const Eigen::Vector4d d = weights_ * (near.array() - q[i]).matrix();
    return {d(0), d(1), d(2), d(3)};
  }
  /// Of the jerk, per standard deviation of the angle.
  [[nodiscard]] double jerk_noise() const { return weights_.row(2).norm(); }

 private:
  Eigen::Index half_;
  Eigen::MatrixXd weights_;
};

struct Row {
  const joint::Recording* recording{};
  std::size_t index{};
  double q{};
  LocalMotion motion;
  std::size_t transient{};
};

constexpr double least_speed_share = 0.05;  // slower: the contact may still build up
constexpr double least_acceleration_share = 0.05;
constexpr double most_lag_s = 0.2;

/// The 99.9 % quantile, so that an outlier does not set the scale.
double largest_usual(std::vector<double> sizes) {
  if (sizes.empty()) return 0;
  const std::size_t rank = sizes.size() - 1 - sizes.size() / 1000;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(rank), sizes.end());
  return sizes[rank];
}

std::vector<LocalMotion> motion_of(const joint::Recording& r, std::size_t half, double dt) {
  const DerivativeWeights weights(half, dt);
  std::vector<LocalMotion> all(r.size());
  for (std::size_t i = half; i + half < r.size(); ++i) all[i] = weights.at(r.q_rad, i);
  return all;
}

struct Scale {
  double speed{}, acceleration{}, jerk{};
};

Scale scale_of(const std::vector<LocalMotion>& all) {
  std::vector<double> v, a, j;
  for (const LocalMotion& m : all) {
    v.push_back(std::abs(m.speed));
    a.push_back(std::abs(m.acceleration));
    j.push_back(std::abs(m.jerk));
  }
  return {largest_usual(std::move(v)), largest_usual(std::move(a)), largest_usual(std::move(j))};
}

/// Adds the rows of a recording's transients; numbers its starts and stops from `transients` on.
void add_rows(const joint::Recording& r, std::vector<Row>& rows, std::size_t& transients) {
  constexpr std::size_t narrowest = 4;
  constexpr std::size_t widest = 40;
  constexpr double most_jerk_noise = 0.1;  // of its largest: what noise takes off its coefficient
  const double dt = statistics::median_interval(r.t_s);
  if (r.size() < 10 * narrowest || !(dt > 0)) return;
  const double noise =
      std::sqrt(std::max(0.0, statistics::white_variance(statistics::third_differences(r.q_rad))));
  for (std::size_t half = narrowest; half <= widest; half = half * 3 / 2) {
    if (r.size() < 8 * half) return;
    const std::vector<LocalMotion> all = motion_of(r, half, dt);
    const Scale scale = scale_of(all);
    if (!(scale.acceleration > 0)) return;
    // A change of speed has to last longer than what the polynomial looks at.
    if (scale.speed / scale.acceleration < static_cast<double>(half) * dt) return;
    if (noise * DerivativeWeights(half, dt).jerk_noise() > most_jerk_noise * scale.jerk) continue;
    bool inside = false;
    for (std::size_t i = half; i + half < r.size(); ++i) {
      const LocalMotion& m = all[i];
      const bool is_even =
          r.t_s[i + half] - r.t_s[i - half] < 1.2 * dt * 2 * static_cast<double>(half);
      const bool is_used =
          std::abs(m.speed) > least_speed_share * scale.speed &&
          std::abs(m.acceleration) > least_acceleration_share * scale.acceleration && is_even &&
          std::isfinite(r.torque_Nm[i]);
      if (is_used) rows.push_back({&r, i, r.q_rad[i], m, transients});
      if (inside && !is_used) ++transients;
      inside = is_used;
    }
    if (inside) ++transients;
    return;
  }
}

/// Knots of the friction polygon over the speed, with equally many rows between them.
std::vector<double> speed_knots(const std::vector<Row>& rows) {
  constexpr std::size_t pieces = 6;
  std::vector<double> speeds;
  for (const Row& row : rows) speeds.push_back(std::abs(row.motion.speed));
  std::sort(speeds.begin(), speeds.end());
  std::vector<double> knots;
  for (std::size_t k = 0; k <= pieces; ++k) {
    knots.push_back(speeds[std::min(speeds.size() - 1, k * speeds.size() / pieces)]);
  }
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

void add_polygon(const std::vector<double>& knots, double speed, Eigen::Ref<Eigen::RowVectorXd> x) {
  const double size = std::clamp(std::abs(speed), knots.front(), knots.back());
  const double sign = speed < 0 ? -1 : 1;
  std::size_t k = 1;
  while (k + 1 < knots.size() && size > knots[k]) ++k;
  const double share = (size - knots[k - 1]) / (knots[k] - knots[k - 1]);
  x(static_cast<Eigen::Index>(k - 1)) = sign * (1 - share);
  x(static_cast<Eigen::Index>(k)) = sign * share;
}

enum Column : Eigen::Index { inertia, lag, curvature, cosine, sine, offset, friction };

/// The torque `lag_s` after a sample, by linear interpolation.
double torque_behind(const Row& row, double lag_s) {
  const joint::Recording& r = *row.recording;
  const double t = r.t_s[row.index] + lag_s;
  std::size_t above = row.index;
  while (above + 1 < r.size() && r.t_s[above] < t) ++above;
  while (above > 1 && r.t_s[above - 1] > t) --above;
  above = std::max<std::size_t>(above, 1);
  const double share = (t - r.t_s[above - 1]) / (r.t_s[above] - r.t_s[above - 1]);
  return std::lerp(r.torque_Nm[above - 1], r.torque_Nm[above], std::clamp(share, 0.0, 1.0));
}

/// Regression of the torque on the rows' motion. A lag removed from the torque beforehand changes
/// only the right-hand side: the coefficient of `lag` is then the remaining lag.
class TransientRegression {
 public:
  TransientRegression(const std::vector<Row>& rows, const std::vector<double>& knots)
      : rows_(rows) {
    const auto size = static_cast<Eigen::Index>(rows.size());
    const auto speeds = static_cast<Eigen::Index>(knots.size());
    x_ = Eigen::MatrixXd::Zero(size, friction + speeds);
    Eigen::RowVectorXd polygon(speeds);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Row& row = rows[static_cast<std::size_t>(i)];
      x_(i, inertia) = row.motion.acceleration;
      x_(i, lag) = -row.motion.jerk;
      x_(i, curvature) = row.motion.snap;
      x_(i, cosine) = std::cos(row.q);
      x_(i, sine) = std::sin(row.q);
      x_(i, offset) = 1;
      polygon.setZero();
      add_polygon(knots, row.motion.speed, polygon);
      x_.row(i).tail(speeds) = polygon;
    }
    norms_ = x_.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
    solved_.compute(x_ * norms_.cwiseInverse().asDiagonal());
  }
  [[nodiscard]] Eigen::VectorXd coefficients(double lag_s) const {
    return solved_.solve(torque(lag_s)).cwiseQuotient(norms_);
  }
  [[nodiscard]] statistics::BlockRegression with_intervals(double lag_s) const {
    std::vector<std::size_t> blocks;
    for (const Row& row : rows_) blocks.push_back(row.transient);
    return statistics::block_regression(x_, torque(lag_s), blocks);
  }

 private:
  [[nodiscard]] Eigen::VectorXd torque(double lag_s) const {
    Eigen::VectorXd y(x_.rows());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      y(static_cast<Eigen::Index>(i)) = torque_behind(rows_[i], lag_s);
    }
    return y;
  }

  const std::vector<Row>& rows_;
  Eigen::MatrixXd x_;
  Eigen::VectorXd norms_;
  Eigen::HouseholderQR<Eigen::MatrixXd> solved_;
};

/// How far the inertia from starts alone and from stops alone is from that from both: what is
/// neither inertia nor a friction that depends on speed acts in opposite senses in them. 0 where
/// either are too few.
double inertia_apart(const std::vector<Row>& rows, const std::vector<double>& knots, double lag_s,
                     double by_both) {
  constexpr std::size_t fewest_rows = 50;
  double farthest = 0;
  for (const bool is_start : {false, true}) {
    std::vector<Row> some;
    for (const Row& row : rows) {
      if ((row.motion.speed * row.motion.acceleration > 0) == is_start) some.push_back(row);
    }
    if (some.size() < fewest_rows) return 0;
    const double alone = TransientRegression(some, knots).coefficients(lag_s)(inertia);
    if (std::isfinite(alone)) farthest = std::max(farthest, std::abs(alone - by_both));
  }
  return farthest;
}

/// 95 % half width of a ratio of two coefficients.
double half_width_of_ratio(const statistics::BlockRegression& fit, Eigen::Index top,
                           Eigen::Index bottom) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.coefficients.size());
  gradient(top) = 1 / fit.coefficients(bottom);
  gradient(bottom) = -fit.coefficients(top) * gradient(top) / fit.coefficients(bottom);
  return fit.half_width_along(gradient);
}

}  // namespace

joint::Recording aligned(const joint::Recording& recording, double lag_s) {
  joint::Recording out = recording;
  if (recording.torque_Nm.empty() || recording.size() < 2) return out;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out.torque_Nm[i] = torque_behind({&recording, i, {}, {}, {}}, lag_s);
  }
  const auto first = std::find_if(out.t_s.begin(), out.t_s.end(),
                                  [&](double t) { return t + lag_s >= recording.t_s.front(); });
  const auto last = std::find_if(first, out.t_s.end(),
                                 [&](double t) { return t + lag_s > recording.t_s.back(); });
  const auto from = first - out.t_s.begin();
  const auto count = last - first;
  for (std::vector<double>* signal : {&out.t_s, &out.q_rad, &out.dq_rad_s, &out.torque_Nm,
                                      &out.z_rad, &out.dz_rad_s, &out.temperature_C}) {
    if (signal->empty()) continue;
    signal->erase(signal->begin() + from + count, signal->end());
    signal->erase(signal->begin(), signal->begin() + from);
  }
  return out;
}

TorqueLag find_torque_lag(const std::vector<const joint::Recording*>& recordings,
                          double gear_ratio) {
  constexpr std::size_t fewest_transients = 6;
  constexpr std::size_t fewest_rows = 100;
  TorqueLag out;
  std::vector<Row> rows;
  for (const joint::Recording* r : recordings) {
    if (r->torque_Nm.size() == r->size()) add_rows(*r, rows, out.transients);
  }
  if (out.transients < fewest_transients || rows.size() < fewest_rows) {
    out.why_not = {"lag.too_few_transients",
                   {{"transients", out.transients}, {"needed", fewest_transients}}};
    return out;
  }
  const std::vector<double> knots = speed_knots(rows);
  if (knots.size() < 2) {
    out.why_not = {"lag.too_few_transients",
                   {{"transients", out.transients}, {"needed", fewest_transients}}};
    return out;
  }
  // Smoothing takes something off the coefficient of the jerk: it is right where it is zero.
  constexpr int most_steps = 12;
  constexpr double last_step_s = 1e-6;
  double lag_s = 0;
  const TransientRegression regression(rows, knots);
  for (int k = 0; k < most_steps; ++k) {
    const Eigen::VectorXd c = regression.coefficients(lag_s);
    const double step = c(lag) / c(inertia);
    if (!(std::abs(step) > last_step_s) || std::abs(lag_s + step) > most_lag_s) break;
    lag_s += step;
  }
  const statistics::BlockRegression fit = regression.with_intervals(lag_s);
  const double inertia_half_width = fit.half_width(inertia);
  if (!(fit.coefficients(inertia) > 2 * inertia_half_width)) {
    out.why_not = {"lag.inertia_not_shown"};
    return out;
  }
  // Behind a filter, starts and stops look late by another share of its time constant than slow
  // loops do, by how short they are.
  constexpr double unlike_a_delay = 0.3;
  const double half_width =
      std::hypot(half_width_of_ratio(fit, lag, inertia), unlike_a_delay * lag_s);
  constexpr Code method{"interval.transients"};
  out.lag_s = statistics::symmetric_estimate(lag_s, half_width, method);
  out.inertia_apart =
      inertia_apart(rows, knots, lag_s, fit.coefficients(inertia)) / fit.coefficients(inertia);
  out.inertia_kgm2 = statistics::symmetric_estimate(fit.coefficients(inertia) / gear_ratio,
                                                    inertia_half_width / gear_ratio, method);
  return out;
}

}  // namespace tribolog::method::motion
