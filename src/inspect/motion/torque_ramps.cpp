#include <algorithm>
#include <cmath>
#include <optional>

#include "inspect/motion/angle_trace.h"
#include "inspect/motion/strokes_and_ramps.h"
#include "statistics/order_statistics.h"

namespace tribolog::inspect::motion {
namespace {

constexpr double smallest_rise = 0.03;       // of the effort's range
constexpr double smallest_unyielding = 0.1;  // of it, where the joint does not move: rest drifts
constexpr double line_share = 0.03;          // of the rise: as far from the line as a ramp may be
constexpr std::size_t level_part = 5;        // of the ramp's samples, that tell the level beside it
constexpr std::size_t fewest_of_level = 5;
constexpr double least_part = 0.7;          // of the stroke's rise that has to lie on the line
constexpr std::size_t fewest_in_ramp = 20;  // as the reader of recordings asks for
constexpr double shortest_s = 1;            // faster ones are starts of a motion
// A joint that slides at the end moves little before; at steady speed it is at half its way.
constexpr double early_share = 0.2;
constexpr double most_before_sliding_rad = 5e-3;  // creep; more is a motion under a rising effort
// One that spins away for longer than it rested: an inertia without friction would take a tenth of
// the time under a constant torque for a hundredth of the way, a fifth under a rising one.
constexpr double creep_share = 0.01;
constexpr double least_rest_share = 0.3;
// A contact that only yields elastically moves in proportion to the torque, but not further.
constexpr double yielding_rad = 2e-3;

/// A stretch without a jump of the effort.
struct Piece {
  std::size_t first{};
  std::size_t last{};
};

struct RampLimits {
  double floor{};  ///< Noise floors of effort and angle.
  double floor_rad{};
  double least_unyielding{};  ///< Rise of a ramp under which the joint does not move.
};

struct Line {
  double at_first{};
  double rate{};
};

Line fit(const AngleTrace& trace, std::size_t first, std::size_t last) {
  double t_mean = 0;
  double y_mean = 0;
  const auto n = static_cast<double>(last - first + 1);
  for (std::size_t i = first; i <= last; ++i) {
    t_mean += trace.t_s[i] / n;
    y_mean += trace.effort[i] / n;
  }
  double tt = 0;
  double ty = 0;
  for (std::size_t i = first; i <= last; ++i) {
    tt += (trace.t_s[i] - t_mean) * (trace.t_s[i] - t_mean);
    ty += (trace.t_s[i] - t_mean) * (trace.effort[i] - y_mean);
  }
  const double rate = tt > 0 ? ty / tt : 0;
  return {y_mean - rate * t_mean, rate};
}

double off_line(const AngleTrace& trace, const Line& line, std::size_t i) {
  return std::abs(trace.effort[i] - line.at_first - line.rate * trace.t_s[i]);
}

/// Where the line leaves the level at which the effort stands before it, or meets the one behind
/// it.
/// @param from, to of the piece without jumps. @param on_line sample well on the line.
/// @param extreme value beyond which the effort does not go on that side.
std::size_t corner(const AngleTrace& trace, const Line& line, std::size_t from, std::size_t to,
                   std::size_t on_line, double extreme, bool is_start) {
  const auto sample_at = [&](double t_s) {
    const auto begin = trace.t_s.begin();
    const auto at = std::lower_bound(begin + static_cast<std::ptrdiff_t>(from),
                                     begin + static_cast<std::ptrdiff_t>(to), t_s);
    return static_cast<std::size_t>(at - begin);
  };
  const auto time_of = [&](double effort) { return (effort - line.at_first) / line.rate; };
  const std::size_t beyond = sample_at(time_of(extreme));
  const std::size_t reach = is_start ? (on_line - std::min(on_line, beyond)) / level_part
                                     : (std::max(on_line, beyond) - on_line) / level_part;
  const std::size_t first = is_start ? std::max(from, beyond - std::min(beyond, reach)) : beyond;
  const std::size_t last = is_start ? beyond : std::min(to, beyond + reach);
  if (last < first + fewest_of_level) return beyond;
  const double level =
      statistics::median({trace.effort.begin() + static_cast<std::ptrdiff_t>(first),
                          trace.effort.begin() + static_cast<std::ptrdiff_t>(last)});
  const std::size_t at = sample_at(time_of(level));
  return is_start ? std::min(at, on_line) : std::max(at, on_line);
}

/// For which share of a ramp's time the joint stays within `creep_rad`.
double rest_share(const AngleTrace& trace, const TorqueRamp& ramp, double creep_rad) {
  std::size_t i = ramp.first;
  while (i < ramp.last && std::abs(trace.q_rad[i] - trace.q_rad[ramp.first]) <= creep_rad) ++i;
  return (trace.t_s[i] - trace.t_s[ramp.first]) / (trace.t_s[ramp.last] - trace.t_s[ramp.first]);
}

/// The part of a rise of the effort, from turn to turn, that is a ramp.
std::optional<TorqueRamp> ramp_in(const AngleTrace& trace, const Piece& piece, std::size_t turn,
                                  std::size_t end, const RampLimits& limits) {
  const double rise = trace.effort[end] - trace.effort[turn];
  const auto reached = [&](double share) {
    std::size_t i = turn;
    while (i < end && (trace.effort[i] - trace.effort[turn]) / rise < share) ++i;
    return i;
  };
  const Line line = fit(trace, reached(0.2), reached(0.8));
  const double tolerance = std::max(line_share * std::abs(rise), limits.floor);
  const std::size_t middle = reached(0.5);
  if (off_line(trace, line, middle) > tolerance) return std::nullopt;
  TorqueRamp ramp{middle, middle, line.rate, false};
  while (ramp.first > turn && off_line(trace, line, ramp.first - 1) <= tolerance) --ramp.first;
  while (ramp.last < end && off_line(trace, line, ramp.last + 1) <= tolerance) ++ramp.last;
  if (ramp.first < middle) {
    ramp.first = corner(trace, line, piece.first, middle, middle, trace.effort[turn], true);
  }
  if (ramp.last > middle) {
    ramp.last = corner(trace, line, middle, piece.last, middle, trace.effort[end], false);
  }
  if (ramp.last - ramp.first + 1 < fewest_in_ramp) return std::nullopt;
  if (trace.t_s[ramp.last] - trace.t_s[ramp.first] < shortest_s) return std::nullopt;
  if (std::abs(trace.effort[ramp.last] - trace.effort[ramp.first]) < least_part * std::abs(rise)) {
    return std::nullopt;
  }
  const double half_s = (trace.t_s[ramp.first] + trace.t_s[ramp.last]) / 2;
  const double creep = std::max(most_before_sliding_rad, limits.floor_rad);
  double early = 0;
  double whole = 0;
  for (std::size_t i = ramp.first; i <= ramp.last; ++i) {
    const double moved = std::abs(trace.q_rad[i] - trace.q_rad[ramp.first]);
    whole = std::max(whole, moved);
    if (trace.t_s[i] <= half_s) early = std::max(early, moved);
  }
  const bool slid_late = early <= early_share * whole && early <= creep;
  const bool spun_away = creep <= early_share * whole &&
                         rest_share(trace, ramp, creep_share * whole) >= least_rest_share;
  ramp.joint_slid = whole > limits.floor_rad && (slid_late || spun_away);
  if (ramp.joint_slid) return ramp;
  const bool yields = whole <= std::max(yielding_rad, limits.floor_rad);
  if (!yields || std::abs(rise) < limits.least_unyielding) return std::nullopt;
  return ramp;
}

/// Last sample before the effort jumps; `last` if it does not.
std::size_t next_jump(const std::vector<double>& effort, std::size_t from, std::size_t last,
                      double jump) {
  while (from < last && std::abs(effort[from + 1] - effort[from]) < jump) ++from;
  return from;
}

}  // namespace

TorqueRampFinder::TorqueRampFinder(const AngleTrace& trace, double floor_rad)
    : trace_(trace), floor_rad_(floor_rad) {
  if (trace.effort.empty()) return;
  const auto [low, high] = std::minmax_element(trace.effort.begin(), trace.effort.end());
  floor_ = noise_floor(trace.effort);
  range_ = *high - *low;
}

std::vector<TorqueRamp> TorqueRampFinder::between(std::size_t first, std::size_t last) const {
  std::vector<TorqueRamp> ramps;
  if (trace_.effort.empty() || last < first + fewest_in_ramp) return ramps;
  const double threshold = std::max(smallest_rise * range_, 2 * floor_);
  if (!(threshold > 0)) return ramps;
  const RampLimits limits{floor_, floor_rad_, smallest_unyielding * range_};
  for (std::size_t begin = first; begin < last;) {
    const std::size_t end = next_jump(trace_.effort, begin, last, threshold);
    const auto turns = turning_points(trace_.effort, begin, end, threshold);
    for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
      const auto ramp = ramp_in(trace_, {begin, end}, turns[k], turns[k + 1], limits);
      if (ramp) ramps.push_back(*ramp);
    }
    begin = end + 1;
  }
  return ramps;
}

}  // namespace tribolog::inspect::motion
