#include "method/hysteresis/steady_loop.h"

#include <algorithm>
#include <cmath>

namespace tribolog::method::hysteresis {
namespace {

/// The last cycle ends one step after the last sample.
double end_of(const LoopTrace& trace) {
  const auto n = static_cast<double>(trace.t_s.size());
  return trace.t_s.back() + (trace.t_s.back() - trace.t_s.front()) / (n - 1);
}

SteadyLoop mean_over_phase(const LoopTrace& trace, double centre, double from_s, double period_s,
                           double cycles, std::size_t bins) {
  std::vector<double> count(bins, 0.0), angle(bins, 0.0), torque(bins, 0.0);
  const double to_s = from_s + cycles * period_s;
  for (std::size_t i = 0; i < trace.t_s.size(); ++i) {
    if (trace.t_s[i] < from_s || trace.t_s[i] >= to_s) continue;
    const double turns = (trace.t_s[i] - from_s) / period_s;
    const double phase = turns - std::floor(turns);
    const auto bin =
        std::min(static_cast<std::size_t>(phase * static_cast<double>(bins)), bins - 1);
    count[bin] += 1;
    angle[bin] += trace.q_rad[i] - centre;
    torque[bin] += trace.torque_Nm[i];
  }
  SteadyLoop loop{centre, {}, {}};
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (count[bin] == 0) continue;
    loop.from_centre_rad.push_back(angle[bin] / count[bin]);
    loop.torque_Nm.push_back(torque[bin] / count[bin]);
  }
  return loop;
}

SteadyLoop thinned(const LoopTrace& trace, double centre, double from_s, std::size_t most) {
  const auto first = static_cast<std::size_t>(
      std::lower_bound(trace.t_s.begin(), trace.t_s.end(), from_s) - trace.t_s.begin());
  const std::size_t all = trace.t_s.size() - first;
  const std::size_t stride = (all + most - 1) / most;
  SteadyLoop loop{centre, {}, {}};
  for (std::size_t i = first; i < trace.t_s.size(); i += std::max<std::size_t>(stride, 1)) {
    loop.from_centre_rad.push_back(trace.q_rad[i] - centre);
    loop.torque_Nm.push_back(trace.torque_Nm[i]);
  }
  return loop;
}

}  // namespace

std::optional<SteadyLoop> steady_loop(const LoopTrace& trace, const Oscillation& oscillation,
                                      std::size_t most_points) {
  constexpr std::size_t fewest = 3;
  const std::size_t n = trace.t_s.size();
  const bool is_whole = trace.q_rad.size() == n && trace.torque_Nm.size() == n;
  if (n < fewest || !is_whole || !(trace.t_s.back() > trace.t_s.front())) return std::nullopt;
  if (!(oscillation.frequency_Hz > 0)) return std::nullopt;
  const double period_s = 1 / oscillation.frequency_Hz;
  const double cycles = std::floor(oscillation.steady_cycles);
  SteadyLoop loop;
  if (cycles >= 2) {
    // No more bins than samples of a cycle, so that none stays empty by chance.
    const double samples = period_s * static_cast<double>(n) / (end_of(trace) - trace.t_s.front());
    const auto bins = std::clamp(static_cast<std::size_t>(samples), fewest, most_points);
    const double from_s = std::max(trace.t_s.front(), end_of(trace) - cycles * period_s);
    loop = mean_over_phase(trace, oscillation.centre_rad, from_s, period_s, cycles, bins);
  } else {
    loop = thinned(trace, oscillation.centre_rad, end_of(trace) - period_s, most_points);
  }
  if (loop.torque_Nm.size() < fewest) return std::nullopt;
  return loop;
}

}  // namespace tribolog::method::hysteresis
