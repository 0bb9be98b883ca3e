#include "method/motion/transients.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "method/motion/encoder_resolution.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::motion {
namespace {

constexpr double least_speed_share = 0.05;  // slower: the contact may still build up
constexpr double least_acceleration_share = 0.05;
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
class TransientFinder {
 public:
  TransientFinder(const std::vector<Travel>& travels, std::size_t number)
      : number_(number), travel_(travels[number]), scale_(scale_of(travel_)) {
    const Eigen::MatrixXd& weights = travel_.smoothed.weights();
    const std::vector<double>& angle = travel_.recording->q_rad;
    const std::size_t step = std::max<std::size_t>(1, travel_.half / 4);
    for (std::size_t i = travel_.half; i + travel_.half < angle.size(); i += step) {
      const Eigen::Map<const Eigen::VectorXd> near(&angle[i - travel_.half], weights.cols());
      const double acceleration = weights.row(2).dot((near.array() - angle[i]).matrix());
      const bool is_steady =
          std::abs(acceleration) <= least_acceleration_share * scale_.acceleration;
      places_.push_back(
          {i, acceleration, is_steady,
           !is_steady && is_within_stroke(travel_, i, least_speed_share * scale_.speed)});
    }
  }

  /// Adds their rows, numbered from `transients` on.
  void add(std::vector<TransientRow>& rows, std::size_t& transients) const {
    for (std::size_t first = 0, end = 0; first < places_.size(); first = end) {
      while (end < places_.size() && places_[end].is_used == places_[first].is_used) ++end;
      if (!places_[first].is_used || !is_transient(first, end)) continue;
      for (std::size_t k = first; k < end; ++k) {
        rows.push_back({number_, places_[k].index, travel_.speed[places_[k].index],
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

  std::size_t number_;
  const Travel& travel_;
  Scale scale_;
  std::vector<Place> places_;
};

/// What a polygon over the speed has besides its last piece, which is a straight line: how far
/// below each knot the speed is.
void add_bends(const std::vector<double>& knots, double speed, Eigen::Ref<Eigen::RowVectorXd> x) {
  const double sign = speed < 0 ? -1 : 1;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    x(static_cast<Eigen::Index>(k)) = sign * std::max(0.0, knots[k] - std::abs(speed));
  }
}

}  // namespace

Transients find_transients(const std::vector<const joint::Recording*>& recordings,
                           double gear_ratio) {
  Transients found;
  for (const joint::Recording* r : recordings) {
    if (r->torque_Nm.size() != r->size()) continue;
    if (std::optional<Travel> travel = travel_of(*r, gear_ratio)) {
      found.travels.push_back(std::move(*travel));
    }
  }
  if (found.travels.empty()) return found;
  // A slow run is over its start before the bristle has bent over: friction then grows with the way
  // and not with the speed, which looks like a lag. Where only few others are left, it counts.
  constexpr double least_share_of_fastest = 0.3;
  constexpr std::size_t enough = 12;
  std::vector<double> speeds;
  for (const Travel& travel : found.travels) speeds.push_back(scale_of(travel).speed);
  const double fastest = *std::max_element(speeds.begin(), speeds.end());
  for (const double least : {least_share_of_fastest * fastest, 0.0}) {
    found.rows.clear();
    found.count = 0;
    for (std::size_t i = 0; i < found.travels.size(); ++i) {
      if (speeds[i] >= least) TransientFinder(found.travels, i).add(found.rows, found.count);
    }
    if (found.count >= enough) break;
  }
  return found;
}

void renumber_transients(std::vector<TransientRow>& rows) {
  std::size_t last = 0;
  std::size_t number = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0 && rows[i].transient != last) ++number;
    last = rows[i].transient;
    rows[i].transient = number;
  }
}

std::vector<double> speed_knots(const std::vector<TransientRow>& rows) {
  constexpr std::size_t pieces = 6;
  std::vector<double> speeds;
  for (const TransientRow& row : rows) speeds.push_back(std::abs(row.speed));
  std::sort(speeds.begin(), speeds.end());
  std::vector<double> knots;
  for (std::size_t k = 1; k < pieces && !speeds.empty(); ++k) {
    knots.push_back(speeds[k * speeds.size() / pieces]);
  }
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

Eigen::MatrixXd forces_at_samples(const Travel& travel, const std::vector<double>& knots) {
  const std::vector<double>& angle = travel.recording->q_rad;
  const auto speeds = static_cast<Eigen::Index>(knots.size());
  Eigen::MatrixXd out(static_cast<Eigen::Index>(angle.size()),
                      static_cast<Eigen::Index>(Force::bends) + speeds);
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

}  // namespace tribolog::method::motion
