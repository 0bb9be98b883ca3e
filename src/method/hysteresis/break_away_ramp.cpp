#include "method/hysteresis/break_away_ramp.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "method/hysteresis/break_away_level.h"
#include "method/motion/encoder_resolution.h"
#include "statistics/linear_systems.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::hysteresis {

namespace {

constexpr double fewest_steps = 20;      // across which a speed is taken
constexpr double share_of_travel = 0.1;  // so that creep and slip are seen at their own scale
// Where a ramp ends before break-away is seen, it may be sliding from this yield on.
constexpr double yield_that_may_slide = 5;
constexpr double torque_on = 0.1;  // share of the largest torque that shows the direction

/// How far the torque gets from its initial value.
double largest_change_Nm(const joint::Recording& r) {
  double largest = 0;
  for (const double torque : r.torque_Nm) {
    largest = std::max(largest, std::abs(torque - r.torque_Nm.front()));
  }
  return largest;
}

/// Of the torque: standard deviation of its white noise.
double white_noise_Nm(const joint::Recording& r) {
  return statistics::white_sd_beside_jumps(statistics::third_differences(r.torque_Nm));
}

/// Samples over which a ramp's torque is averaged where single ones are too noisy.
std::size_t window_of(const joint::Recording& r) {
  constexpr std::size_t share = 100;
  constexpr std::size_t most = 50;
  return std::clamp<std::size_t>(r.size() / share, 1, most);
}

/// Where a ramp begins, and whether towards positive torque.
struct RampBegin {
  std::size_t sample{};
  double sign{1};
};

/// Where the torque first leaves its initial level: earlier motion is not due to the ramp. By means
/// over a hundredth of the ramp, for single samples of a noisy torque leave it at any time.
RampBegin begin_of_ramp(const joint::Recording& r, double noise) {
  const std::size_t window = window_of(r);
  // Two means of noise alone differ by as much once in many thousands.
  constexpr double clear = 4;
  const double rest = std::max(torque_on * largest_change_Nm(r),
                               clear * noise * std::sqrt(2 / static_cast<double>(window)));
  double sum = 0;
  for (std::size_t i = 0; i < window; ++i) sum += r.torque_Nm[i];
  const double first = sum / static_cast<double>(window);
  double change = 0;
  std::size_t i = 0;
  for (; i + window < r.size() && std::abs(change) <= rest; ++i) {
    sum += r.torque_Nm[i + window] - r.torque_Nm[i];
    change = sum / static_cast<double>(window) - first;
  }
  // A short one may leave it within its last window.
  if (std::abs(change) <= rest) change = r.torque_Nm.back() - first;
  return {std::min(i + window / 2, r.size() - 1), change < 0 ? -1.0 : 1.0};
}

/// Where the torque is largest in the ramp's direction, by means over some samples; and the last
/// sample at which noise leaves that in doubt.
struct RampEnd {
  std::size_t largest{};
  std::size_t last{};
};

RampEnd end_of_ramp(const joint::Recording& r, double sign, double noise) {
  constexpr double in_doubt = 2;  // standard deviations
  std::vector<double> sum{0};
  for (const double torque : r.torque_Nm) sum.push_back(sum.back() + sign * torque);
  const std::size_t beside = window_of(r) / 2;
  const auto mean = [&](std::size_t i) {
    const std::size_t half = std::min({beside, i, r.size() - 1 - i});
    return (sum[i + half + 1] - sum[i - half]) / static_cast<double>(2 * half + 1);
  };
  std::size_t largest = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (mean(i) > mean(largest)) largest = i;
  }
  std::size_t last = r.size() - 1;
  while (last > 0 && mean(last) < mean(largest) - in_doubt * noise) --last;
  return {largest, last};
}

/// A straight line through the torque of some samples that end with one.
struct TorqueLine {
  double at_end_Nm{};
  double variance_Nm2{};  ///< Of the samples about it.
};

TorqueLine line_up_to(const joint::Recording& r, std::size_t at, std::size_t count) {
  const std::size_t first = at + 1 - count;
  const auto n = static_cast<double>(count);
  const auto from_middle = [n](std::size_t k) { return static_cast<double>(k) - (n - 1) / 2; };
  double mean = 0;
  double slope = 0;
  for (std::size_t k = 0; k < count; ++k) {
    mean += r.torque_Nm[first + k] / n;
    slope += from_middle(k) * r.torque_Nm[first + k] * 12 / (n * (n * n - 1));
  }
  double squares = 0;
  for (std::size_t k = 0; k < count; ++k) {
    squares += std::pow(r.torque_Nm[first + k] - mean - slope * from_middle(k), 2);
  }
  return {mean + slope * (n - 1) / 2, squares / (n - 2)};
}

/// A ramp's torque at a sample.
struct TorqueAt {
  double torque_Nm{};
  double standard_error_Nm{};
};

/// By a straight line through the samples before it.
TorqueAt torque_by_line(const joint::Recording& r, std::size_t at, double noise) {
  constexpr std::size_t share = 20;
  constexpr std::size_t most = 50;
  constexpr std::size_t fewest = 4;
  const std::size_t count =
      std::min(std::clamp<std::size_t>(r.size() / share, 2 * fewest, most), at + 1);
  if (count < fewest) return {r.torque_Nm[at], noise};
  return {line_up_to(r, at, count).at_end_Nm, 2 * noise / std::sqrt(static_cast<double>(count))};
}

/// Standard deviation of what hangs together in a torque's noise, such as a vibration, about a
/// straight line through the last part of a ramp: white noise does not show it.
double coloured_noise_Nm(const joint::Recording& r, std::size_t at, double noise) {
  constexpr std::size_t share = 4;
  constexpr std::size_t fewest = 20;
  const std::size_t count = std::min(std::max(r.size() / share, fewest), at + 1);
  if (count < fewest) return 0;
  const double white = noise * noise;
  const double coloured = line_up_to(r, at, count).variance_Nm2 - white;
  return coloured > white ? std::sqrt(coloured) : 0;  // less is a matter of chance
}

/// What the torque has certainly reached at a sample.
double torque_reached_Nm(const joint::Recording& r, std::size_t at, double sign, double noise) {
  const TorqueAt reached = torque_by_line(r, at, noise);
  constexpr double white = 2;
  constexpr double coloured = 3;  // the largest bound of several ramps is said
  return reached.torque_Nm - sign * std::hypot(white * reached.standard_error_Nm,
                                               coloured * coloured_noise_Nm(r, at, noise));
}

/// A sample's own torque, where its noise does not matter.
double torque_at_Nm(const joint::Recording& r, std::size_t at, double noise) {
  constexpr double matters = 0.05;
  const bool is_noisy = noise > matters * std::abs(r.torque_Nm[at]);
  return is_noisy ? torque_by_line(r, at, noise).torque_Nm : r.torque_Nm[at];
}

/// The usual step of the angle from sample to sample, zero steps left out: the encoder's step or
/// its noise, whichever shows. From the part that certainly rests, up to half of the ramp's torque:
/// steps in sliding are larger, but whole multiples of an encoder's.
double usual_step_rad(const joint::Recording& r) {
  const double largest = largest_change_Nm(r);
  std::vector<double> at_rest;
  std::vector<double> all;
  bool rests = true;
  for (std::size_t i = 1; i < r.size(); ++i) {
    rests = rests && std::abs(r.torque_Nm[i] - r.torque_Nm.front()) < largest / 2;
    if (r.q_rad[i] == r.q_rad[i - 1]) continue;
    all.push_back(std::abs(r.q_rad[i] - r.q_rad[i - 1]));
    if (rests) at_rest.push_back(all.back());
  }
  if (all.empty()) return 0;
  constexpr std::size_t enough = 5;
  if (at_rest.size() >= enough) return statistics::median(std::move(at_rest));
  const double encoder = motion::common_step(r.q_rad);
  if (encoder > 0) return encoder;
  // Of a rest without any and a short slide: none is smaller than the encoder's.
  constexpr std::size_t few = 10;
  return all.size() < few ? *std::min_element(all.begin(), all.end())
                          : statistics::median(std::move(all));
}

/// Where the joint has moved `need` on from sample i, or the end.
std::size_t moved_on(const statistics::Summits& travel, std::size_t i, double need) {
  const double here = travel.signal()[i];
  return travel.first(i + 1, [&](double there) { return there - here >= need; });
}

/// Mean speed up to where the torque has risen half as far as at a sample, its first twentieth left
/// out; to be called for samples in their order.
class SpeedOfFirstHalf {
 public:
  SpeedOfFirstHalf(const joint::Recording& r, double sign) : r_(r), sign_(sign) {}
  /// @param smallest travel that can be resolved.
  [[nodiscard]] double before(std::size_t i, const std::vector<double>& travel, double least) {
    constexpr double begin = 0.05;
    constexpr double half = 0.5;
    const double risen = rise(i);
    while (begin_ < i && rise(begin_) < begin * risen) ++begin_;
    half_ = std::max(half_, begin_);
    while (half_ < i && rise(half_) < half * risen) ++half_;
    const double time_s = r_.t_s[half_] - r_.t_s[begin_];
    return time_s > 0 ? std::max(travel[half_] - travel[begin_], least) / time_s : INFINITY;
  }

 private:
  [[nodiscard]] double rise(std::size_t i) const {
    return sign_ * (r_.torque_Nm[i] - r_.torque_Nm.front());
  }
  const joint::Recording& r_;
  double sign_;
  std::size_t begin_{0};
  std::size_t half_{0};
};

/// Travel from break-away at sample `at` to where the joint has slowed down to a third of the speed
/// at which break-away was detected.
std::optional<double> slip_until_stop(const joint::Recording& r, const statistics::Summits& summits,
                                      std::size_t at, std::size_t end, double least) {
  const std::vector<double>& travel = summits.signal();
  const double need = std::max(least, share_of_travel * travel[at]);
  const double mean_speed = std::max(travel[at], least) / (r.t_s[at] - r.t_s.front());
  const double stopped = yield_at_break_away / 3 * mean_speed;
  for (std::size_t i = at + 1; i < end; ++i) {
    const std::size_t j = std::min(moved_on(summits, i, need), end);
    if (need <= stopped * (r.t_s[j] - r.t_s[i])) return travel[i] - travel[at];
  }
  return std::nullopt;
}

/// Acceleration of a parabola through the samples [first, last], of which `at` is one.
double acceleration_of(const joint::Recording& r, std::size_t first, std::size_t at,
                       std::size_t last) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double span = r.t_s[last] - r.t_s[first];
  for (std::size_t i = first; i <= last; ++i) {
    const double s = (r.t_s[i] - r.t_s[at]) / span;
    const Eigen::Vector3d x(1, s, s * s);
    normal += x * x.transpose();
    right += x * (r.q_rad[i] - r.q_rad[at]);
  }
  return 2 * statistics::solve_normal(normal, right)(2, 0) / (span * span);
}

/// Acceleration at a sample, and how far it may be from that.
struct Acceleration {
  double value{};
  double half_width{};
};

/// The joint runs away from there: a parabola through `beside` samples on either side has more than
/// the acceleration at the sample, one through those before it has less. It is known no better than
/// to a quarter of itself.
Acceleration acceleration_at(const joint::Recording& r, std::size_t at, std::size_t beside) {
  constexpr double least = 0.25;
  const std::size_t first = at > beside ? at - beside : 0;
  const double most = acceleration_of(r, first, at, std::min(r.size() - 1, at + beside));
  const double before = acceleration_of(r, first, at, at);
  const double fewest = most > 0 ? std::clamp(before, 0.0, most) : std::clamp(before, most, 0.0);
  const double value = (most + fewest) / 2;
  return {value, std::max(std::abs(most - fewest) / 2, least * std::abs(value))};
}

/// Where friction was largest before a sample at which the joint runs away: an inertia that is
/// large for the ramp is seen to run away late, when friction has fallen to what it is in sliding.
/// @param rest_Nm torque less gravity, in the ramp's direction.
/// @param inertia_along at the joint, signed as the ramp is.
std::size_t where_it_held_most(const joint::Recording& r, std::size_t at, std::size_t beside,
                               const std::vector<double>& rest_Nm, double inertia_along) {
  const auto friction_about = [&](std::size_t i) {
    const std::size_t first = i - std::min(i, beside / 2);
    const std::size_t last = std::min(r.size() - 1, i + beside / 2);
    double sum = 0;
    for (std::size_t k = first; k <= last; ++k) sum += rest_Nm[k];
    return sum / static_cast<double>(last - first + 1) -
           inertia_along * acceleration_at(r, i, beside).value;
  };
  constexpr std::size_t farthest = 4;
  const std::size_t step = std::max<std::size_t>(1, beside / 4);
  const std::size_t first = at - std::min(at, farthest * beside);
  double most = friction_about(at);
  std::size_t held = at;
  for (std::size_t i = at; i >= first + step; i -= step) {
    const double before = friction_about(i - step);
    if (before <= most) continue;
    most = before;
    held = i - step;
  }
  return held;
}

/// @param rest_Nm of the ramp's first samples, in its direction.
/// @param half_window over which the angle's slopes are taken.
void take_off_inertia(const joint::Recording& r, std::size_t half_window, double inertia_along,
                      std::vector<double>& rest_Nm) {
  const std::vector<double> acceleration = statistics::local_curvature(r.t_s, r.q_rad, half_window);
  for (std::size_t i = 0; i < rest_Nm.size(); ++i) rest_Nm[i] -= inertia_along * acceleration[i];
}

}  // namespace

BreakAwayRamp read_ramp(const joint::Recording& r, const BreakAwayResult& result,
                        double inertia_at_joint, double behind_s) {
  BreakAwayRamp ramp;
  ramp.recording = r.name;
  const double noise = white_noise_Nm(r);
  const auto [begin, sign] = begin_of_ramp(r, noise);
  ramp.is_rising = sign > 0;
  ramp.q_start_rad = r.q_rad.front();
  std::vector<double> way(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) way[i] = sign * (r.q_rad[i] - r.q_rad.front());
  const statistics::Summits summits(std::move(way));
  const std::vector<double>& travel = summits.signal();
  const double least = fewest_steps * usual_step_rad(r);
  const auto [largest, furthest] = end_of_ramp(r, sign, noise);
  std::size_t furthest_at_rest = largest;
  std::size_t at = furthest;
  std::size_t beside = 0;
  SpeedOfFirstHalf first_half(r, sign);
  for (std::size_t i = begin + 1; i < furthest; ++i) {
    const double need = std::max(least, share_of_travel * travel[i]);
    const std::size_t j = moved_on(summits, i, need);
    if (j == r.size()) break;
    // A ramp of even rate began a tenth of its torque before.
    const double time_s = (r.t_s[i] - r.t_s[begin]) / (1 - torque_on);
    const double mean_speed = std::max(travel[i], least) / time_s;
    if (!(mean_speed > 0)) continue;
    const double yield = need / (r.t_s[j] - r.t_s[i]) / mean_speed;
    ramp.largest_yield = std::max(ramp.largest_yield, yield);
    if (yield > yield_that_may_slide) furthest_at_rest = std::min(furthest_at_rest, i);
    const double speed_up = need / (r.t_s[j] - r.t_s[i]) / first_half.before(i, travel, least);
    if (yield > yield_at_break_away || speed_up > speed_up_at_break_away) {
      ramp.broke_away = true;
      at = i;
      beside = j - i;
      break;
    }
  }
  constexpr std::size_t fewest_beside = 3;
  constexpr std::size_t beside_the_end = 10;
  std::vector<double> rest_Nm;  // torque less gravity
  for (std::size_t i = 0; i < r.size(); ++i) {
    rest_Nm.push_back(result.torque_along(ramp.is_rising, r.torque_Nm[i], r.q_rad[i]));
  }
  if (!ramp.broke_away) {
    at = furthest_at_rest;
    beside = beside_the_end;
    // An angle that flickers by a step while a torque is held does not slide.
    const auto level = travel.back() >= least ? level_of_even_slide(travel, rest_Nm) : std::nullopt;
    if (level) {
      ramp.broke_away = true;
      ramp.level_Nm = level;
      ramp.even_slide_rad_s = travel.back() / (r.t_s.back() - r.t_s[begin]);
      beside = 0;
    }
  }
  const bool shows_acceleration = beside >= fewest_beside;
  const bool knows_inertia = shows_acceleration && inertia_at_joint > 0;
  if (ramp.broke_away && knows_inertia) {
    at = where_it_held_most(r, at, beside, rest_Nm, sign * inertia_at_joint);
  }
  ramp.torque_Nm =
      ramp.broke_away ? torque_at_Nm(r, at, noise) : torque_reached_Nm(r, largest, sign, noise);
  if (shows_acceleration) {
    const Acceleration acceleration = acceleration_at(r, at, beside);
    ramp.inertia_Nm = sign * inertia_at_joint * acceleration.value;
    ramp.inertia_half_width_Nm = inertia_at_joint * acceleration.half_width;
    if (!ramp.broke_away) {  // it stays a bound
      ramp.inertia_Nm = std::max(0.0, ramp.inertia_Nm + ramp.inertia_half_width_Nm);
    }
  }
  ramp.friction_Nm =
      result.torque_along(ramp.is_rising, ramp.torque_Nm, r.q_rad[at]) - ramp.inertia_Nm;
  if (ramp.level_Nm) {
    ramp.friction_Nm = share_at_reading * *ramp.level_Nm;
  } else if (ramp.broke_away) {
    rest_Nm.resize(at);
    if (knows_inertia) take_off_inertia(r, beside, sign * inertia_at_joint, rest_Nm);
    ramp.level_Nm = level_at_rest(travel, rest_Nm, ramp.friction_Nm);
    const double rise_s = r.t_s[at] - r.t_s[begin];
    if (ramp.level_Nm && rise_s > 0) {
      // In an even ramp that is as much at all angles, and so in their level.
      *ramp.level_Nm -= behind_s * (ramp.friction_Nm - rest_Nm[begin]) / rise_s;
    }
  }
  ramp.travel_rad = travel[at];
  if (ramp.broke_away && !ramp.even_slide_rad_s)
    ramp.first_slip_rad = slip_until_stop(r, summits, at, furthest, least);
  const double duration = r.t_s[at] - r.t_s.front();
  ramp.rate_Nm_s = duration > 0 ? sign * (ramp.torque_Nm - r.torque_Nm.front()) / duration : 0.0;
  ramp.samples_used = at + 1;
  ramp.samples_left_out = r.size() - ramp.samples_used;
  return ramp;
}

}  // namespace tribolog::method::hysteresis
