#include "method/motion/torque_lag.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "method/motion/encoder_resolution.h"
#include "statistics/block_regression.h"
#include "statistics/distributions.h"
#include "statistics/linear_systems.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"
#include "statistics/smoothed_derivatives.h"

namespace tribolog::method::motion {
namespace {

/// A recording whose starts and stops are looked at.
struct Travel {
  const joint::Recording* recording{};
  std::size_t half{};  ///< Samples to either side that a row is made of.
  double dt_s{};
  statistics::SmoothedDerivatives smoothed;
  std::vector<double> speed;  ///< Of each sample.
};

/// The smoothed torque about one sample against the motion smoothed likewise.
struct Row {
  const Travel* travel{};
  std::size_t index{};
  double speed{}, acceleration{};
  std::size_t transient{};
};

constexpr double least_speed_share = 0.05;  // slower: the contact may still build up
constexpr double least_acceleration_share = 0.05;
constexpr double most_lag_s = 0.2;
constexpr std::size_t fewest_rows = 50;

double square(double x) { return x * x; }

/// The 99.9 % quantile, so that an outlier does not set the scale.
double largest_usual(std::vector<double> sizes) {
  if (sizes.empty()) return 0;
  const std::size_t rank = sizes.size() - 1 - sizes.size() / 1000;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(rank), sizes.end());
  return sizes[rank];
}

/// Of each sample; 0 where there are too few beside it.
std::vector<double> speeds_of(const joint::Recording& r,
                              const statistics::SmoothedDerivatives& smoothed) {
  const Eigen::RowVectorXd weights = smoothed.weights().row(1);
  const auto half = static_cast<std::size_t>(weights.size() / 2);
  std::vector<double> speeds(r.size());
  for (std::size_t i = half; i + half < r.size(); ++i) {
    const Eigen::Map<const Eigen::VectorXd> near(&r.q_rad[i - half], weights.size());
    speeds[i] = weights.dot((near.array() - r.q_rad[i]).matrix());
  }
  return speeds;
}

struct Scale {
  double speed{}, acceleration{}, jerk{};
};

Scale scale_of(const Travel& travel) {
  const Eigen::MatrixXd& weights = travel.smoothed.weights();
  const std::vector<double>& angle = travel.recording->q_rad;
  std::vector<double> v, a, j;
  for (std::size_t i = travel.half; i + travel.half < angle.size(); ++i) {
    const Eigen::Map<const Eigen::VectorXd> near(&angle[i - travel.half], weights.cols());
    const Eigen::VectorXd d = weights * (near.array() - angle[i]).matrix();
    v.push_back(std::abs(d(1)));
    a.push_back(std::abs(d(2)));
    j.push_back(std::abs(d(3)));
  }
  return {largest_usual(std::move(v)), largest_usual(std::move(a)), largest_usual(std::move(j))};
}

/// Samples about which the joint keeps moving one way, all of them recorded.
bool is_within_stroke(const Travel& travel, std::size_t i, double least_speed) {
  const joint::Recording& r = *travel.recording;
  const std::size_t half = travel.half;
  if (i < 2 * half || i + 2 * half >= r.size()) return false;
  if (r.t_s[i + half] - r.t_s[i - half] > 2.4 * travel.dt_s * static_cast<double>(half)) {
    return false;
  }
  const double sign = travel.speed[i] < 0 ? -1 : 1;
  for (std::size_t k = i - half; k <= i + half; ++k) {
    if (!(sign * travel.speed[k] > least_speed) || !std::isfinite(r.torque_Nm[k])) {
      return false;
    }
  }
  return true;
}

/// How widely a recording has to be smoothed, and its motion; nothing where its starts and stops
/// are too short for that.
std::optional<Travel> travel_of(const joint::Recording& r, double gear_ratio) {
  constexpr std::size_t narrowest = 4;
  constexpr std::size_t widest = 60;
  constexpr double most_jerk_noise = 0.1;  // of its largest: what noise takes off its coefficient
  const double dt_s = statistics::even_interval(r.t_s);
  if (r.size() < 10 * narrowest || !(dt_s > 0)) return std::nullopt;
  // An angle that stands between the encoder's steps shows none of its noise.
  const double noise = std::max(
      std::sqrt(std::max(0.0, statistics::white_variance(statistics::third_differences(r.q_rad)))),
      angle_step(r.q_rad, gear_ratio).step_rad / std::sqrt(12.0));
  for (std::size_t half = narrowest; half <= widest; half = half * 3 / 2) {
    if (r.size() < 8 * half) return std::nullopt;
    Travel out{&r, half, dt_s, statistics::SmoothedDerivatives(half, dt_s), {}};
    const Scale scale = scale_of(out);
    if (!(scale.acceleration > 0)) return std::nullopt;
    // A change of speed has to last longer than what a row looks at.
    if (scale.speed / scale.acceleration < static_cast<double>(half) * dt_s) {
      return std::nullopt;
    }
    const Eigen::VectorXd noises = noise * out.smoothed.weights().rowwise().norm();
    if (noises(3) > most_jerk_noise * scale.jerk) continue;
    // Plateaus would be taken for transients.
    if (noises(2) > least_acceleration_share / 4 * scale.acceleration) continue;
    out.speed = speeds_of(r, out.smoothed);
    return out;
  }
  return std::nullopt;
}

/// Starts, stops and changes of speed among the places of a travel that are looked at. Ripple that
/// makes a running joint faster and slower is none of them: there the torque follows the speed by
/// way of the controller, and what accelerates the joint is not in the log.
class Transients {
 public:
  explicit Transients(const Travel& travel) : travel_(travel), scale_(scale_of(travel)) {
    const Eigen::MatrixXd& weights = travel.smoothed.weights();
    const std::vector<double>& angle = travel.recording->q_rad;
    const std::size_t step = std::max<std::size_t>(1, travel.half / 4);
    for (std::size_t i = travel.half; i + travel.half < angle.size(); i += step) {
      const Eigen::Map<const Eigen::VectorXd> near(&angle[i - travel.half], weights.cols());
      const double acceleration = weights.row(2).dot((near.array() - angle[i]).matrix());
      const bool is_steady =
          std::abs(acceleration) <= least_acceleration_share * scale_.acceleration;
      places_.push_back(
          {i, acceleration, is_steady,
           !is_steady && is_within_stroke(travel, i, least_speed_share * scale_.speed)});
    }
  }

  /// Adds their rows, numbered from `transients` on.
  void add(std::vector<Row>& rows, std::size_t& transients) const {
    for (std::size_t first = 0, end = 0; first < places_.size(); first = end) {
      while (end < places_.size() && places_[end].is_used == places_[first].is_used) ++end;
      if (!places_[first].is_used || !is_transient(first, end)) continue;
      for (std::size_t k = first; k < end; ++k) {
        rows.push_back({&travel_, places_[k].index, travel_.speed[places_[k].index],
                        places_[k].acceleration, transients});
      }
      ++transients;
    }
  }

 private:
  struct Place {
    std::size_t index{};
    double acceleration{};
    bool is_steady{};
    bool is_used{};
  };

  [[nodiscard]] bool is_transient(std::size_t first, std::size_t end) const {
    constexpr double least_change = 0.3;  // of the fastest speed
    double low = scale_.speed;
    double high = 0;
    for (std::size_t k = first; k < end; ++k) {
      low = std::min(low, std::abs(travel_.speed[places_[k].index]));
      high = std::max(high, std::abs(travel_.speed[places_[k].index]));
    }
    if (high - low < least_change * scale_.speed) return false;
    const bool is_between_plateaus =
        steady_before(first) >= end - first && steady_from(end) >= end - first;
    return is_between_plateaus || rests_beside(places_[first].index, places_[end - 1].index);
  }

  /// Numbers of steady places that lie there without a gap.
  [[nodiscard]] std::size_t steady_before(std::size_t place) const {
    std::size_t count = 0;
    while (count < place && places_[place - 1 - count].is_steady) ++count;
    return count;
  }
  [[nodiscard]] std::size_t steady_from(std::size_t place) const {
    std::size_t count = 0;
    while (place + count < places_.size() && places_[place + count].is_steady) ++count;
    return count;
  }

  /// Whether the joint stands or turns right before or right behind these samples.
  [[nodiscard]] bool rests_beside(std::size_t first, std::size_t last) const {
    const std::size_t half = travel_.half;
    const std::size_t reach = 2 * half;
    const std::size_t from = std::max(half, first > reach ? first - reach : 0);
    const std::size_t to = std::min(travel_.recording->size() - half, last + reach);
    for (std::size_t i = from; i < to; ++i) {
      if (i >= first && i <= last) continue;
      if (std::abs(travel_.speed[i]) <= least_speed_share * scale_.speed) return true;
    }
    return false;
  }

  const Travel& travel_;
  Scale scale_;
  std::vector<Place> places_;
};

/// Numbers the transients of some rows from 0 on without gaps.
void renumber_transients(std::vector<Row>& rows) {
  std::size_t last = 0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].transient != last) ++number;
    last = rows[i].transient;
    rows[i].transient = number;
  }
}

/// Where the friction polygon over the speed bends: as many rows between any two.
std::vector<double> speed_knots(const std::vector<Row>& rows) {
  constexpr std::size_t pieces = 6;
  std::vector<double> speeds;
  for (const Row& row : rows) speeds.push_back(std::abs(row.speed));
  std::sort(speeds.begin(), speeds.end());
  std::vector<double> knots;
  for (std::size_t k = 1; k < pieces && !speeds.empty(); ++k) {
    knots.push_back(speeds[k * speeds.size() / pieces]);
  }
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

/// What a polygon over the speed has besides its last piece, which is a straight line: how far
/// below each knot the speed is.
void add_bends(const std::vector<double>& knots, double speed, Eigen::Ref<Eigen::RowVectorXd> x) {
  const double sign = speed < 0 ? -1 : 1;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    x(static_cast<Eigen::Index>(k)) = sign * std::max(0.0, knots[k] - std::abs(speed));
  }
}

enum Column : Eigen::Index {
  inertia,
  lag,
  curvature,
  viscous,
  cosine,
  sine,
  offset,
  coulomb,
  bends
};

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

/// What acts at each sample of a travel besides inertia: the columns from `cosine` on.
Eigen::MatrixXd forces_at_samples(const Travel& travel, const std::vector<double>& knots) {
  const std::vector<double>& angle = travel.recording->q_rad;
  const auto speeds = static_cast<Eigen::Index>(knots.size());
  Eigen::MatrixXd out(static_cast<Eigen::Index>(angle.size()), bends - cosine + speeds);
  Eigen::RowVectorXd bent(speeds);
  for (std::size_t i = 0; i < angle.size(); ++i) {
    auto row = out.row(static_cast<Eigen::Index>(i));
    const double speed = travel.speed[i];
    row(0) = std::cos(angle[i]);
    row(1) = std::sin(angle[i]);
    row(2) = 1;
    row(3) = speed < 0 ? -1 : 1;
    add_bends(knots, speed, bent);
    row.tail(speeds) = bent;
  }
  return out;
}

/// Regression of the torque on the motion, both smoothed alike. A lag removed from the torque
/// beforehand changes only the right-hand side: the coefficient of `lag` is then the remaining lag.
class TransientRegression {
 public:
  TransientRegression(const std::vector<Row>& rows, const std::vector<double>& knots)
      : rows_(rows) {
    const auto speeds = static_cast<Eigen::Index>(knots.size());
    x_.resize(static_cast<Eigen::Index>(rows.size()), bends + speeds);
    Eigen::MatrixXd forces;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Travel& travel = *rows[i].travel;
      if (i == 0 || &travel != rows[i - 1].travel) forces = forces_at_samples(travel, knots);
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
      x.tail(forces.cols()) =
          weights.row(0) * forces.middleRows(static_cast<Eigen::Index>(first), weights.cols());
    }
    norms_ = x_.colwise().norm().transpose().unaryExpr([](double n) { return n > 0 ? n : 1.0; });
    solved_ = statistics::OrthogonalColumns(x_ * norms_.cwiseInverse().asDiagonal());
  }
  [[nodiscard]] Eigen::VectorXd coefficients(double lag_s) const {
    return solved_.solve(torque(lag_s)).col(0).cwiseQuotient(norms_);
  }
  [[nodiscard]] statistics::BlockRegression with_intervals(double lag_s) const {
    std::vector<std::size_t> blocks;
    for (const Row& row : rows_) blocks.push_back(row.transient);
    return statistics::block_regression(x_, torque(lag_s), blocks);
  }

 private:
  [[nodiscard]] Eigen::VectorXd torque(double lag_s) const {
    Eigen::VectorXd y(x_.rows());
    std::vector<double> behind;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Travel& travel = *rows_[i].travel;
      if (i == 0 || &travel != rows_[i - 1].travel)
        behind = torques_behind(*travel.recording, lag_s);
      const auto weights = travel.smoothed.weights().row(0);
      const Eigen::Map<const Eigen::VectorXd> about(&behind[rows_[i].index - travel.half],
                                                    weights.cols());
      y(static_cast<Eigen::Index>(i)) = weights * about;
    }
    return y;
  }

  const std::vector<Row>& rows_;
  Eigen::MatrixXd x_;
  Eigen::VectorXd norms_;
  statistics::OrthogonalColumns solved_;
};

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
Apart starts_and_stops_apart(const std::vector<Row>& rows, const std::vector<double>& knots,
                             double lag_s, const statistics::BlockRegression& both) {
  Apart farthest;
  for (const bool is_start : {false, true}) {
    std::vector<Row> some;
    for (const Row& row : rows) {
      if ((row.speed * row.acceleration > 0) == is_start) some.push_back(row);
    }
    if (some.size() < fewest_rows) return {};
    renumber_transients(some);
    const statistics::BlockRegression alone =
        TransientRegression(some, knots).with_intervals(lag_s);
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

}  // namespace

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
double time_of(const std::vector<Row>& rows) {
  double sum_s = 0;
  for (const Row& row : rows) {
    const std::vector<double>& t = row.travel->recording->t_s;
    sum_s += (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  }
  return sum_s;
}

}  // namespace

TorqueLag find_torque_lag(const std::vector<const joint::Recording*>& recordings,
                          double gear_ratio) {
  constexpr std::size_t fewest_transients = 6;
  TorqueLag out;
  std::vector<Travel> travels;
  for (const joint::Recording* r : recordings) {
    if (r->torque_Nm.size() != r->size()) continue;
    if (std::optional<Travel> travel = travel_of(*r, gear_ratio))
      travels.push_back(std::move(*travel));
  }
  std::vector<Row> rows;
  for (const Travel& travel : travels) Transients(travel).add(rows, out.transients);
  if (out.transients < fewest_transients || rows.size() < fewest_rows) {
    out.why_not = {"lag.too_few_transients",
                   {{"transients", out.transients}, {"needed", fewest_transients}}};
    return out;
  }
  const std::vector<double> knots = speed_knots(rows);
  // Noise of the angle takes something off the coefficient of the jerk: it is right at zero.
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
  // Where something else moves the joint, such as ripple that its controller follows, the torque is
  // an answer to the acceleration and not its cause; no coefficient is then what it is meant to be.
  constexpr double most_unexplained = 0.5;
  double squares = 0;
  for (const Row& row : rows) squares += square(row.acceleration);
  const double of_inertia_Nm =
      std::abs(fit.coefficients(inertia)) * std::sqrt(squares / static_cast<double>(rows.size()));
  out.hides_inertia = true;
  if (!(fit.residual_sd < most_unexplained * of_inertia_Nm)) {
    out.why_not = {"lag.other_torques",
                   {{"rest_Nm", fit.residual_sd}, {"inertia_Nm", of_inertia_Nm}}};
    return out;
  }
  const Apart apart = starts_and_stops_apart(rows, knots, lag_s, fit);
  // Friction of a start is first the bristle's, and not that of its speed.
  constexpr double share_of_model = 0.003;
  const double inertia_half_width = std::hypot(fit.half_width(inertia), apart.inertia,
                                               share_of_model * fit.coefficients(inertia));
  if (!(fit.coefficients(inertia) > 2 * inertia_half_width)) {
    out.why_not = {"lag.inertia_not_shown"};
    return out;
  }
  out.hides_inertia = false;
  out.lag_over_transients = std::abs(lag_s) * static_cast<double>(out.transients) / time_of(rows);
  // Behind a filter, starts and stops look late by another share of its time constant than slow
  // loops do, by how short they are.
  constexpr double unlike_a_delay = 0.3;
  const double half_width =
      std::hypot(half_width_of_ratio(fit, lag, inertia), unlike_a_delay * lag_s, apart.lag_s);
  constexpr Code method{"interval.transients"};
  out.lag_s = statistics::symmetric_estimate(lag_s, half_width, method);
  out.inertia_apart = apart.inertia / fit.coefficients(inertia);
  out.inertia_kgm2 = statistics::symmetric_estimate(fit.coefficients(inertia) / gear_ratio,
                                                    inertia_half_width / gear_ratio, method);
  return out;
}

}  // namespace tribolog::method::motion
