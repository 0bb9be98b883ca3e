#include "method/hysteresis/break_away.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <Eigen/Core>

#include "base/requirements.h"
#include "method/hysteresis/break_away_level.h"
#include "method/hysteresis/position_mean.h"
#include "method/motion/encoder_resolution.h"
#include "statistics/distributions.h"
#include "statistics/group_mean.h"
#include "statistics/linear_systems.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::hysteresis {

namespace {

constexpr double fewest_steps = 20;      // across which a speed is taken
constexpr double share_of_travel = 0.1;  // so that creep and slip are seen at their own scale
// Where a ramp ends before break-away is seen, it may be sliding from this yield on.
constexpr double yield_that_may_slide = 5;
constexpr double torque_on = 0.1;  // share of the largest torque that tells the direction

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

/// A LuGre contact is seen to yield at this share of its static torque.
constexpr double share_at_reading = 0.993;

/// @param result says what gravity is taken off.
/// @param behind_s of the bristle's torque (BehindTorque).
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

/// Of the ramps of one direction that broke away; absent with fewer than two.
struct RampMean {
  double value{};
  double scatter{};  ///< 95 % half width.
};

std::optional<RampMean> mean_over(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (n < 2) return std::nullopt;
  double mean = 0;
  for (const double v : values) mean += v / n;
  double squares = 0;
  for (const double v : values) squares += std::pow(v - mean, 2);
  return RampMean{mean, statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n)};
}

/// Ramps that start within this much of each other start at one motor angle: friction of six
/// periods a turn changes by an eighth of one.
constexpr double one_position_rad = 0.13;

/// Motor angles in groups of one position, ascending.
std::vector<std::vector<std::size_t>> by_position(const std::vector<double>& motor_angle_rad) {
  std::vector<std::size_t> order(motor_angle_rad.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return motor_angle_rad[a] < motor_angle_rad[b];
  });
  std::vector<std::vector<std::size_t>> groups;
  double first = 0;
  for (const std::size_t i : order) {
    if (groups.empty() || motor_angle_rad[i] - first > one_position_rad) {
      groups.emplace_back();
      first = motor_angle_rad[i];
    }
    groups.back().push_back(i);
  }
  return groups;
}

/// The ramps of one direction as means over their angles.
class OverAngles {
 public:
  /// @param has_gravity ramps at different angles differ by it: none can then be compared.
  OverAngles(const std::vector<double>& motor_angle_rad, bool has_gravity,
             const gravity::CogSweepResult& sweep)
      : share_of_sweep_(share_of_friction_left(sweep, motor_angle_rad)) {
    if (!has_gravity) groups_ = by_position(motor_angle_rad);
  }

  /// Takes the mean over angles where ramps differ by them.
  /// @return 95 % half width of what the angles leave, beside the scatter of the ramps.
  [[nodiscard]] double take(const std::vector<double>& values, RampMean& mean) {
    std::vector<std::vector<double>> by_angle;
    for (const std::vector<std::size_t>& group : groups_) {
      by_angle.emplace_back();
      for (const std::size_t i : group) by_angle.back().push_back(values[i]);
    }
    const auto over_angles = statistics::mean_of_groups_that_differ(by_angle);
    const double by_sweep = share_of_sweep_ * std::abs(mean.value);
    constexpr double matters = 0.002;
    const double between =
        over_angles ? over_angles->between_sd / std::abs(over_angles->mean) : 0.0;
    if (!(between > matters)) return by_sweep;
    between_ = between;
    mean = {over_angles->mean, 0};
    // Two say that there is a difference, not how large it is elsewhere: the sweep does.
    const bool is_told_by_sweep = groups_.size() == 2 && by_sweep > 0;
    const double by_ramps = is_told_by_sweep ? over_angles->largest_off : over_angles->half_width;
    return std::max(by_ramps, by_sweep);
  }
  [[nodiscard]] std::size_t positions() const { return groups_.size(); }
  [[nodiscard]] double between() const { return between_; }

 private:
  std::vector<std::vector<std::size_t>> groups_;
  double share_of_sweep_{};
  double between_{0};
};

/// Half widths of what may shift both directions alike.
struct InCommon {
  double by_angle_Nm{};
  double by_inertia_Nm{};  ///< And by damping.
  double by_contact_Nm{};  ///< Between reading and level: the interval holds both.
};

/// Of one direction.
struct DirectionMean {
  statistics::Estimate torque_Nm;  ///< All in.
  double own_Nm{};                 ///< Half width of what is this direction's own.
  InCommon in_common;
};

DirectionMean direction_mean(double value, double own_Nm, const InCommon& common, Code method) {
  const Statement plain{method};
  const Statement why = common.by_angle_Nm > 0 ? Statement{"interval.widened_by_friction_of_angle",
                                                           {{"interval", plain}}}
                                               : plain;
  const double half_width =
      std::hypot(own_Nm, common.by_angle_Nm, common.by_inertia_Nm) + common.by_contact_Nm;
  return {statistics::symmetric_estimate(value, half_width, why), own_Nm, common};
}

/// Whether the ramps of a direction that broke away, if there are any, bend far enough to show
/// their levels: two at least, and all but every third.
bool has_levels(const std::vector<BreakAwayRamp>& ramps, bool is_rising) {
  std::size_t broke_away = 0;
  std::size_t levels = 0;
  for (const BreakAwayRamp& ramp : ramps) {
    if (!ramp.broke_away || ramp.is_rising != is_rising) continue;
    ++broke_away;
    levels += ramp.level_Nm ? 1 : 0;
  }
  constexpr std::size_t fewest = 2;
  return levels == broke_away || (levels >= fewest && 3 * levels >= 2 * broke_away);
}

/// @param is_level the levels at rest are the values, and are compared with the readings.
/// @param result `apart` is raised to the difference of these two beyond their noise; it receives
/// what the positions show.
std::optional<DirectionMean> mean_of(const std::vector<BreakAwayRamp>& ramps, bool is_rising,
                                     bool is_level, const std::optional<KnownGravity>& gravity,
                                     double gear_ratio, const gravity::CogSweepResult& sweep,
                                     double behind_half_width_s, BreakAwayResult& result) {
  std::vector<double> readings;
  std::vector<double> levels;
  std::vector<double> motor_angles;
  double by_gravity = 0;
  double by_inertia = 0;
  double by_damping = 0;
  for (const BreakAwayRamp& ramp : ramps) {
    if (!ramp.broke_away || ramp.is_rising != is_rising) continue;
    readings.push_back(ramp.friction_Nm);
    if (is_level && ramp.level_Nm) levels.push_back(*ramp.level_Nm);
    if (!is_level || ramp.level_Nm) motor_angles.push_back(gear_ratio * ramp.q_start_rad);
    by_inertia += ramp.inertia_half_width_Nm;
    if (!ramp.even_slide_rad_s) by_damping += behind_half_width_s * ramp.rate_Nm_s;
    if (gravity) {
      by_gravity += gravity->amplitude_Nm.half_width() *
                    std::abs(std::cos(ramp.q_start_rad - gravity->q_peak_rad));
    }
  }
  std::optional<RampMean> reading = mean_over(readings);
  if (!reading) return std::nullopt;
  OverAngles angles(motor_angles, !gravity, sweep);
  by_gravity /= static_cast<double>(readings.size());
  by_inertia /= static_cast<double>(readings.size());
  by_damping /= static_cast<double>(readings.size());
  const auto told = [&] {
    result.positions = std::max(result.positions, angles.positions());
    result.between_positions = std::max(result.between_positions, angles.between());
  };
  if (!is_level) {
    const double by_angle = angles.take(readings, *reading);
    told();
    return direction_mean(reading->value, std::hypot(reading->scatter, by_gravity),
                          {by_angle, by_inertia, 0}, "interval.scatter_of_ramps");
  }
  RampMean level = present(mean_over(levels));
  const double difference = std::abs(reading->value - share_at_reading * level.value);
  const double noise = std::hypot(reading->scatter, level.scatter);
  // Which of the two is the joint's, another contact decides: beyond their noise the interval holds
  // both.
  const double by_contact = difference > noise ? difference : 0;
  result.apart = std::max(result.apart, by_contact / level.value);
  const double by_angle = angles.take(levels, level);
  told();
  return direction_mean(level.value, std::hypot(level.scatter, by_gravity),
                        {by_angle, by_damping, by_contact}, "interval.scatter_of_ramps_at_rest");
}

/// Of both directions: their own errors average, what they have in common does not.
statistics::Estimate mean_of_both(const DirectionMean& rising, const DirectionMean& falling) {
  const InCommon& up = rising.in_common;
  const InCommon& down = falling.in_common;
  return direction_mean(
             (rising.torque_Nm.value + falling.torque_Nm.value) / 2,
             std::hypot(rising.own_Nm, falling.own_Nm) / 2,
             {(up.by_angle_Nm + down.by_angle_Nm) / 2, (up.by_inertia_Nm + down.by_inertia_Nm) / 2,
              (up.by_contact_Nm + down.by_contact_Nm) / 2},
             "interval.scatter_of_ramps_both_directions")
      .torque_Nm;
}

void add_reason(statistics::StageReport& stage, const Statement& reason) {
  stage.state = statistics::StageState::partial;
  stage.reason.add(reason);
}

/// What the ramps that did not break away say: the largest of their bounds.
void add_censored(BreakAwayResult& result) {
  const BreakAwayRamp* largest = nullptr;
  for (const BreakAwayRamp& ramp : result.ramps) {
    if (ramp.broke_away) continue;
    if (largest == nullptr || ramp.friction_Nm > largest->friction_Nm) largest = &ramp;
  }
  if (largest == nullptr) return;
  if (!(largest->friction_Nm > 0)) {
    add_reason(result.stage, {"break_away.censored_without_bound",
                              {{"count", result.censored}, {"ramps", result.ramps.size()}}});
    return;
  }
  add_reason(result.stage,
             {result.censored == 1 ? Code{"break_away.censored"} : Code{"break_away.some_censored"},
              {{"count", result.censored},
               {"ramps", result.ramps.size()},
               {"recording", largest->recording},
               {"torque_Nm", largest->torque_Nm},
               {"friction_Nm", largest->friction_Nm}}});
}

/// In which direction fewer than two ramps broke away.
Code too_few_ramps(const BreakAwayResult& result) {
  if (result.rising_Nm) return {"break_away.too_few_towards_negative"};
  if (result.falling_Nm) return {"break_away.too_few_towards_positive"};
  return {"break_away.too_few_in_either_direction"};
}

}  // namespace

BreakAwayResult identify_break_away(const std::vector<const joint::Recording*>& ramps,
                                    const std::optional<KnownGravity>& gravity,
                                    double inertia_at_joint, double gear_ratio,
                                    const gravity::CogSweepResult& sweep,
                                    const BehindTorque& behind) {
  BreakAwayResult out;
  out.stage.name = "break_away";
  out.gravity = gravity;
  if (ramps.empty()) {
    out.stage.state = statistics::StageState::skipped;
    out.stage.reason = {"break_away.no_ramps"};
    return out;
  }
  for (const joint::Recording* r : ramps) {
    if (r->size() < 3) continue;
    out.ramps.push_back(read_ramp(*r, out, inertia_at_joint, behind.time_s));
    out.censored += out.ramps.back().broke_away ? 0 : 1;
  }
  out.is_level = gravity && out.censored < out.ramps.size() && has_levels(out.ramps, true) &&
                 has_levels(out.ramps, false);
  const auto rising =
      mean_of(out.ramps, true, out.is_level, gravity, gear_ratio, sweep, behind.half_width_s, out);
  const auto falling =
      mean_of(out.ramps, false, out.is_level, gravity, gear_ratio, sweep, behind.half_width_s, out);
  if (rising) out.rising_Nm = rising->torque_Nm;
  if (falling) out.falling_Nm = falling->torque_Nm;
  if (rising && falling) out.mean_Nm = mean_of_both(*rising, *falling);
  out.stage.state = statistics::StageState::done;
  add_censored(out);
  if (!out.rising_Nm || !out.falling_Nm) add_reason(out.stage, too_few_ramps(out));
  if (!gravity) add_reason(out.stage, {"break_away.gravity_not_taken_off"});
  if (!out.rising_Nm && !out.falling_Nm) out.stage.state = statistics::StageState::not_identifiable;
  return out;
}

namespace {

/// Friction that the joint holds in one direction, beyond the scatter of its ramps. Of single
/// readings the largest would be their noise.
double surely_held(const BreakAwayResult& ramps, bool is_rising) {
  const std::optional<statistics::Estimate>& mean = is_rising ? ramps.rising_Nm : ramps.falling_Nm;
  double held = mean ? mean->low : 0;
  for (const BreakAwayRamp& ramp : ramps.ramps) {
    const bool is_in_mean = mean && ramp.broke_away;
    if (ramp.is_rising == is_rising && !is_in_mean) held = std::max(held, ramp.friction_Nm);
  }
  return held;
}

/// How friction falls with speed is read relative to the level.
bool rests_on_level(LuGreParameterName name) {
  return name == LuGreParameterName::coulomb_torque || name == LuGreParameterName::stribeck_speed ||
         name == LuGreParameterName::speed_weakening;
}

void withdraw(LuGreParameter& parameter, Statement why_not, Statement experiment) {
  parameter.estimate.reset();
  parameter.why_not = std::move(why_not);
  parameter.experiment = std::move(experiment);
}

}  // namespace

LuGreFit against_ramps(LuGreFit fit, const BreakAwayResult& ramps) {
  const auto level = fit.shown(LuGreParameterName::static_torque);
  if (!level || ramps.ramps.empty()) return fit;
  // Gravity that was not taken off helps one direction by what it hinders the other: the smaller
  // of the two is held in any case.
  const double rising = surely_held(ramps, true);
  const double falling = surely_held(ramps, false);
  const double held = rising > 0 && falling > 0 ? std::min(rising, falling) : 0;
  if (!(level->high < held)) return fit;
  const Statement contradiction{"lugre.contradicted_by_ramps",
                                {{"level_Nm", level->value}, {"held_Nm", held}}};
  for (LuGreParameter& p : fit.parameters) {
    if (p.name == LuGreParameterName::static_torque) {
      withdraw(p, contradiction, {"lugre_experiment.ramps_that_slide"});
    } else if (p.estimate && rests_on_level(p.name)) {
      withdraw(p, {"lugre.rests_on_contradicted_level"}, {"lugre_experiment.runs"});
    }
  }
  fit.reason.add(contradiction);
  return fit;
}

}  // namespace tribolog::method::hysteresis
