#include "method/motion/torque_lag.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include "base/requirements.h"
#include "method/motion/lost_rows.h"
#include "method/motion/transients.h"
#include "statistics/block_regression.h"
#include "statistics/linear_systems.h"
#include "statistics/rival_fits.h"

namespace tribolog::method::motion {
namespace {

constexpr double most_lag_s = 0.2;
constexpr std::size_t fewest_rows = 50;

double square(double x) { return x * x; }

/// Columns of the regression; behind them the forces.
enum Column : Eigen::Index { inertia, lag, curvature, viscous, forces_from };

/// The torque `lag_s` after a sample, by linear interpolation.
double torque_behind(const joint::Recording& r, std::size_t index, double lag_s) {
  const double t = r.t_s[index] + lag_s;
  std::size_t above = index;
  while (above + 1 < r.size() && r.t_s[above] < t) ++above;
  while (above > 1 && r.t_s[above - 1] > t) --above;
  above = std::max<std::size_t>(above, 1);
  const double share = (t - r.t_s[above - 1]) / (r.t_s[above] - r.t_s[above - 1]);
  return std::lerp(r.torque_Nm[above - 1], r.torque_Nm[above], std::clamp(share, 0.0, 1.0));
}

std::vector<double> torques_behind(const joint::Recording& r, double lag_s) {
  std::vector<double> out(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) out[i] = torque_behind(r, i, lag_s);
  return out;
}

/// Regression of the torque on the motion, both smoothed alike. A lag removed from the torque
/// beforehand changes only the right-hand side: the coefficient of `lag` is then the remaining lag.
class TransientRegression {
 public:
  /// @param whole_s > 0: the last column is that of the lag times the time, in this unit.
  TransientRegression(const std::vector<Travel>& travels, const std::vector<TransientRow>& rows,
                      const std::vector<double>& knots, double whole_s = 0)
      : travels_(travels), rows_(rows) {
    const auto columns =
        static_cast<Eigen::Index>(Force::bends) + static_cast<Eigen::Index>(knots.size());
    const bool over_time = whole_s > 0;
    x_.resize(static_cast<Eigen::Index>(rows.size()), forces_from + columns + (over_time ? 1 : 0));
    Eigen::MatrixXd forces;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Travel& travel = travels[rows[i].travel];
      if (i == 0 || rows[i].travel != rows[i - 1].travel) forces = forces_at_samples(travel, knots);
      const Eigen::MatrixXd& weights = travel.smoothed.weights();
      const std::size_t first = rows[i].index - travel.half;
      const Eigen::Map<const Eigen::VectorXd> angle(&travel.recording->q_rad[first],
                                                    weights.cols());
      const Eigen::VectorXd motion =
          weights.bottomRows(4) * (angle.array() - travel.recording->q_rad[rows[i].index]).matrix();
      auto x = x_.row(static_cast<Eigen::Index>(i));
      x(viscous) = motion(0);
      x(inertia) = motion(1);
      x(lag) = -motion(2);
      x(curvature) = motion(3);
      x.segment(forces_from, columns) =
          weights.row(0) * forces.middleRows(static_cast<Eigen::Index>(first), weights.cols());
      if (over_time) x.tail<1>()(0) = x(lag) * travel.recording->t_s[rows[i].index] / whole_s;
    }
    norms_ = x_.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
    solved_ = statistics::OrthogonalColumns(x_ * norms_.cwiseInverse().asDiagonal());
  }
  [[nodiscard]] Eigen::VectorXd coefficients(double lag_s) const {
    return solved_.solve(torque(lag_s)).col(0).cwiseQuotient(norms_);
  }
  /// What the torque keeps beside all columns, once the lag is removed [N·m, norm over the rows].
  [[nodiscard]] double left_beside(double lag_s) const {
    return (torque(lag_s) - x_ * coefficients(lag_s)).norm();
  }
  [[nodiscard]] statistics::BlockRegression with_intervals(double lag_s) const {
    return statistics::block_regression(x_, torque(lag_s), blocks());
  }
  /// Start or stop of each row.
  [[nodiscard]] std::vector<std::size_t> blocks() const {
    std::vector<std::size_t> out;
    for (const TransientRow& row : rows_) out.push_back(row.transient);
    return out;
  }

 private:
  [[nodiscard]] Eigen::VectorXd torque(double lag_s) const {
    Eigen::VectorXd y(x_.rows());
    std::vector<double> behind;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Travel& travel = travels_[rows_[i].travel];
      if (i == 0 || rows_[i].travel != rows_[i - 1].travel) {
        behind = torques_behind(*travel.recording, lag_s);
      }
      const auto weights = travel.smoothed.weights().row(0);
      const Eigen::Map<const Eigen::VectorXd> about(&behind[rows_[i].index - travel.half],
                                                    weights.cols());
      y(static_cast<Eigen::Index>(i)) = weights * about;
    }
    return y;
  }

  const std::vector<Travel>& travels_;
  const std::vector<TransientRow>& rows_;
  Eigen::MatrixXd x_;
  Eigen::VectorXd norms_;
  statistics::OrthogonalColumns solved_;
};

/// The lag that is left where the torque was moved back by one, and so on until none is.
double settled_lag_s(const TransientRegression& regression, double lag_s) {
  constexpr int most_steps = 12;
  constexpr double last_step_s = 1e-6;
  for (int k = 0; k < most_steps; ++k) {
    const Eigen::VectorXd c = regression.coefficients(lag_s);
    // Noise of the angle takes something off the coefficient of the jerk: it is right at zero.
    const double step = c(lag) / c(inertia);
    if (!(std::abs(step) > last_step_s) || std::abs(lag_s + step) > most_lag_s) break;
    lag_s += step;
  }
  return lag_s;
}

/// From zero the steps reach a lag that is shorter than starts and stops are; a longer one is
/// looked for from the lag that leaves least, and taken where it leaves less beyond doubt.
double found_lag_s(const TransientRegression& regression) {
  constexpr double shortest_s = 4e-3;
  constexpr double ratio = 1.5;
  constexpr double least_gain = 0.02;
  double best_s = 0;
  double least = regression.left_beside(0);
  for (double size_s = shortest_s; size_s < most_lag_s; size_s *= ratio) {
    for (const double lag_s : {size_s, -size_s}) {
      const double left = regression.left_beside(lag_s);
      if (left >= least) continue;
      least = left;
      best_s = lag_s;
    }
  }
  const double near_s = settled_lag_s(regression, 0);
  const double far_s = settled_lag_s(regression, best_s);
  const bool is_better = statistics::leaves_less(regression.with_intervals(far_s).residuals,
                                                 regression.with_intervals(near_s).residuals,
                                                 regression.blocks(), least_gain);
  return is_better ? far_s : near_s;
}

/// 95 % half width of a ratio of two coefficients.
double half_width_of_ratio(const statistics::BlockRegression& fit, Eigen::Index top,
                           Eigen::Index bottom) {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(fit.coefficients.size());
  gradient(top) = 1 / fit.coefficients(bottom);
  gradient(bottom) = -fit.coefficients(top) * gradient(top) / fit.coefficients(bottom);
  return fit.half_width_along(gradient);
}

/// What is not noise in the difference of two 95 % estimates of which one rests on part of the data
/// of the other.
double beyond_noise(double difference, double half_width_of_part, double half_width_of_all) {
  const double noise = square(half_width_of_part) - square(half_width_of_all);
  return std::sqrt(std::max(0.0, square(difference) - std::max(0.0, noise)));
}

/// How far starts alone and stops alone are from both together, whichever is farther, beyond their
/// noise: what is neither inertia nor a friction that depends on speed acts in opposite senses in
/// them.
struct Apart {
  double inertia{};  ///< As its coefficient.
  double lag_s{};
};

/// 0 where either are too few.
Apart starts_and_stops_apart(const Transients& transients, const std::vector<double>& knots,
                             double lag_s, const statistics::BlockRegression& both) {
  Apart farthest;
  for (const bool is_start : {false, true}) {
    std::vector<TransientRow> some;
    for (const TransientRow& row : transients.rows) {
      if ((row.speed * row.acceleration > 0) == is_start) some.push_back(row);
    }
    if (some.size() < fewest_rows) return {};
    renumber_transients(some);
    const statistics::BlockRegression alone =
        TransientRegression(transients.travels, some, knots).with_intervals(lag_s);
    const auto& c = alone.coefficients;
    if (!std::isfinite(c(inertia)) || !(c(inertia) > 0)) return {};
    farthest.inertia = std::max(farthest.inertia,
                                beyond_noise(c(inertia) - both.coefficients(inertia),
                                             alone.half_width(inertia), both.half_width(inertia)));
    farthest.lag_s = std::max(
        farthest.lag_s, beyond_noise(c(lag) / c(inertia), half_width_of_ratio(alone, lag, inertia),
                                     half_width_of_ratio(both, lag, inertia)));
  }
  return farthest;
}

double time_of(const TransientRow& row, const Transients& transients) {
  return transients.travels[row.travel].recording->t_s[row.index];
}

/// By how much the lag changes from the first to the last of the starts and stops, by their
/// recordings' clocks, if it changes evenly. None where it may be chance.
std::optional<statistics::Estimate> change_of_lag(const Transients& transients,
                                                  const std::vector<double>& knots, double lag_s) {
  constexpr double beyond_doubt = 2;  // half widths
  double first_s = std::numeric_limits<double>::infinity();
  double last_s = -first_s;
  for (const TransientRow& row : transients.rows) {
    first_s = std::min(first_s, time_of(row, transients));
    last_s = std::max(last_s, time_of(row, transients));
  }
  const double whole_s = last_s - first_s;
  if (!(whole_s > 0)) return std::nullopt;
  const TransientRegression regression(transients.travels, transients.rows, knots, whole_s);
  const statistics::BlockRegression fit = regression.with_intervals(lag_s);
  const Eigen::Index over_time = fit.coefficients.size() - 1;
  const double change_s = fit.coefficients(over_time) / fit.coefficients(inertia);
  const double half_width_s = half_width_of_ratio(fit, over_time, inertia);
  if (!(std::abs(change_s) > beyond_doubt * half_width_s)) return std::nullopt;
  return statistics::symmetric_estimate(change_s, half_width_s, {"interval.transients"});
}

}  // namespace

const LagRival* TorqueLag::rival(LagShape of) const {
  const auto it = std::find_if(rivals.begin(), rivals.end(),
                               [&](const LagRival& one) { return one.shape == of; });
  return it == rivals.end() ? nullptr : &*it;
}

TorqueRounding TorqueLag::rounding() const {
  if (!is_clear() || present(lag_s).value < 0) return {};
  if (shape) return {*shape, present(lag_s).value};
  return {LagShape::filter, rounds_as_filter_s / std::numbers::sqrt2};
}

double TorqueLag::unknown_rounding_s() const {
  if (!is_clear()) return 0;
  if (!rounding().any()) return rounds_as_filter_s;
  // It rounds by its square.
  const statistics::Estimate& size = present(lag_s);
  const double share = shape ? 2 * size.half_width() / size.value : 0.5;
  return rounds_as_filter_s * std::sqrt(std::min(1.0, share));
}

joint::Recording aligned(const joint::Recording& recording, double lag_s) {
  joint::Recording out = recording;
  if (recording.torque_Nm.empty() || recording.size() < 2) return out;
  out.torque_Nm = torques_behind(recording, lag_s);
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

namespace {

/// That all rows take together.
double time_of(const Transients& transients) {
  double sum_s = 0;
  for (const TransientRow& row : transients.rows) {
    const std::vector<double>& t = transients.travels[row.travel].recording->t_s;
    sum_s += (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  }
  return sum_s;
}

}  // namespace

TorqueLag find_torque_lag(const std::vector<const joint::Recording*>& recordings,
                          double gear_ratio) {
  constexpr std::size_t fewest_transients = 6;
  TorqueLag out;
  std::vector<joint::Recording> whole;
  whole.reserve(recordings.size());
  std::vector<const joint::Recording*> looked_at = recordings;
  for (const joint::Recording*& r : looked_at) {
    if (!has_lost_rows(*r)) continue;
    whole.push_back(with_lost_rows(*r));
    r = &whole.back();
  }
  const Transients transients = find_transients(looked_at, gear_ratio);
  const std::vector<TransientRow>& rows = transients.rows;
  out.transients = transients.count;
  if (transients.count < fewest_transients || rows.size() < fewest_rows) {
    out.why_not = {"lag.too_few_transients",
                   {{"transients", out.transients}, {"needed", fewest_transients}}};
    return out;
  }
  const std::vector<double> knots = speed_knots(rows);
  const TransientRegression regression(transients.travels, rows, knots);
  const double lag_s = found_lag_s(regression);
  const statistics::BlockRegression fit = regression.with_intervals(lag_s);
  // Where something else moves the joint, such as ripple that its controller follows, the torque is
  // an answer to the acceleration and not its cause; no coefficient is then what it is meant to be.
  constexpr double most_unexplained = 0.5;
  double squares = 0;
  for (const TransientRow& row : rows) squares += square(row.acceleration);
  const double of_inertia_Nm =
      std::abs(fit.coefficients(inertia)) * std::sqrt(squares / static_cast<double>(rows.size()));
  out.hides_inertia = true;
  if (!(fit.residual_sd < most_unexplained * of_inertia_Nm)) {
    out.why_not = {"lag.other_torques",
                   {{"rest_Nm", fit.residual_sd}, {"inertia_Nm", of_inertia_Nm}}};
    return out;
  }
  const Apart apart = starts_and_stops_apart(transients, knots, lag_s, fit);
  out.change_s = change_of_lag(transients, knots, lag_s);
  // Friction of a start is first the bristle's, and not that of its speed.
  constexpr double share_of_model = 0.003;
  const double inertia_half_width = std::hypot(fit.half_width(inertia), apart.inertia,
                                               share_of_model * fit.coefficients(inertia));
  if (!(fit.coefficients(inertia) > 2 * inertia_half_width)) {
    out.why_not = {"lag.inertia_not_shown"};
    return out;
  }
  out.hides_inertia = false;
  out.inertia_apart = apart.inertia / fit.coefficients(inertia);
  out.lag_over_transients =
      std::abs(lag_s) * static_cast<double>(out.transients) / time_of(transients);
  // Behind a filter, starts and stops look late by another share of its time constant than slow
  // loops do, by how short they are.
  constexpr double unlike_a_delay = 0.3;
  const double changes_s = out.change_s ? std::abs(out.change_s->value) : 0.0;
  const double lag_noise_s =
      std::hypot(half_width_of_ratio(fit, lag, inertia), apart.lag_s, changes_s);
  double shape_s = unlike_a_delay * std::abs(lag_s);
  const bool is_clear = std::abs(lag_s) > std::hypot(lag_noise_s, shape_s);
  const bool is_elastic = fit.coefficients(curvature) < -2 * fit.half_width(curvature);
  if (is_clear || is_elastic) {
    LagCompetition competition = let_rivals_compete(transients, knots, lag_s);
    out.rivals = std::move(competition.rivals);
    out.shape = competition.winner;
    out.rounds_as_filter_s = competition.rounds_as_filter_s;
  }
  const LagRival* delay = out.rival(LagShape::delay);
  const LagRival* filter = out.rival(LagShape::filter);
  const LagRival* rounding = out.shape == LagShape::filter        ? filter
                             : out.shape == LagShape::moving_mean ? out.rival(LagShape::moving_mean)
                                                                  : nullptr;
  double inertia_here = fit.coefficients(inertia);
  double inertia_noise = inertia_half_width;
  double size_s = lag_s;
  double size_noise_s = lag_noise_s;
  if (rounding != nullptr) {
    out.change_s.reset();  // its lag depends on how short the starts are
    inertia_here = rounding->inertia_kgm2;
    inertia_noise =
        std::hypot(rounding->inertia_half_width, apart.inertia, share_of_model * inertia_here);
    size_s = rounding->size_s;
    size_noise_s = std::hypot(rounding->half_width_s, apart.lag_s);
  }
  const LagRival* mean = out.rival(LagShape::moving_mean);
  if (rounding != nullptr || out.shape == LagShape::delay) {
    shape_s = 0;
  } else if (delay != nullptr && filter != nullptr && mean != nullptr) {
    // Each is as late as it would be if the torque had its shape: they may agree.
    const auto [least_s, most_s] = std::minmax({delay->size_s, filter->size_s, mean->size_s});
    size_s = (least_s + most_s) / 2;
    shape_s = (most_s - least_s) / 2;
    size_noise_s = std::hypot(
        lag_noise_s, std::max({delay->half_width_s, filter->half_width_s, mean->half_width_s}));
  } else if (delay != nullptr && filter != nullptr) {
    shape_s = std::max(shape_s, std::abs(filter->size_s - delay->size_s));
  }
  constexpr Code method{"interval.transients"};
  out.lag_s = statistics::symmetric_estimate(size_s, std::hypot(size_noise_s, shape_s), method);
  out.inertia_kgm2 =
      statistics::symmetric_estimate(inertia_here / gear_ratio, inertia_noise / gear_ratio, method);
  return out;
}

}  // namespace tribolog::method::motion
