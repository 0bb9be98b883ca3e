#include "inspect/motion/torque_ramps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "inspect/motion/noise_floor.h"
#include "inspect/motion/turning_points.h"

namespace tribolog {
namespace {

constexpr double smallest_rise = 0.1;       // of the effort's range
constexpr double line_share = 0.03;         // of the rise: as far from the line as a ramp may be
constexpr double least_part = 0.7;          // of the stroke's rise that has to lie on the line
constexpr std::size_t fewest_samples = 20;  // as the reader of recordings asks for
constexpr double shortest_s = 1;            // faster ones are starts of a motion
// A joint that slides at the end moves little before; at steady speed it is at half its way.
constexpr double early_share = 0.2;
// A contact that only yields elastically moves in proportion to the torque, but not further.
constexpr double yielding_rad = 2e-3;

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

/// The part of a rise of the effort, from turn to turn, that is a ramp.
std::optional<TorqueRamp> ramp_in(const AngleTrace& trace, std::size_t turn, std::size_t end,
                                  double floor, double floor_rad) {
  const double rise = trace.effort[end] - trace.effort[turn];
  const auto reached = [&](double share) {
    std::size_t i = turn;
    while (i < end && (trace.effort[i] - trace.effort[turn]) / rise < share) ++i;
    return i;
  };
  const Line line = fit(trace, reached(0.2), reached(0.8));
  const double tolerance = std::max(line_share * std::abs(rise), floor);
  const std::size_t middle = reached(0.5);
  if (off_line(trace, line, middle) > tolerance) return std::nullopt;
  TorqueRamp ramp{middle, middle, line.rate, false};
  while (ramp.first > turn && off_line(trace, line, ramp.first - 1) <= tolerance) --ramp.first;
  while (ramp.last < end && off_line(trace, line, ramp.last + 1) <= tolerance) ++ramp.last;
  if (ramp.last - ramp.first + 1 < fewest_samples) return std::nullopt;
  if (trace.t_s[ramp.last] - trace.t_s[ramp.first] < shortest_s) return std::nullopt;
  if (std::abs(trace.effort[ramp.last] - trace.effort[ramp.first]) < least_part * std::abs(rise)) {
    return std::nullopt;
  }
  const double half_s = (trace.t_s[ramp.first] + trace.t_s[ramp.last]) / 2;
  double early = 0;
  double whole = 0;
  for (std::size_t i = ramp.first; i <= ramp.last; ++i) {
    const double moved = std::abs(trace.q_rad[i] - trace.q_rad[ramp.first]);
    whole = std::max(whole, moved);
    if (trace.t_s[i] <= half_s) early = std::max(early, moved);
  }
  ramp.joint_slid = early <= early_share * whole && whole > floor_rad;
  if (!ramp.joint_slid && whole > std::max(yielding_rad, floor_rad)) return std::nullopt;
  return ramp;
}

}  // namespace

std::vector<TorqueRamp> find_torque_ramps(const AngleTrace& trace, std::size_t first,
                                          std::size_t last, double floor_rad) {
  std::vector<TorqueRamp> ramps;
  if (trace.effort.empty() || last < first + fewest_samples) return ramps;
  const auto [low, high] = std::minmax_element(trace.effort.begin(), trace.effort.end());
  const double floor = noise_floor(trace.effort);
  const double threshold = std::max(smallest_rise * (*high - *low), 2 * floor);
  if (!(threshold > 0)) return ramps;
  const auto turns = turning_points(trace.effort, first, last, threshold);
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    const auto ramp = ramp_in(trace, turns[k], turns[k + 1], floor, floor_rad);
    if (ramp) ramps.push_back(*ramp);
  }
  return ramps;
}

}  // namespace tribolog
