#include "method/motion/false_stamps.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "statistics/order_statistics.h"

namespace tribolog::method::motion {
namespace {

/// An even clock: the count of each stamp, and the times of the counts.
struct EvenClock {
  std::vector<double> count;
  double start_s{};
  double interval_s{};  ///< 0: there is none.
  double scatter_s{};   ///< Standard deviation of the stamps about it.
};

/// Counts that a clock of this interval gives the stamps, each from where the last ones were: a
/// lost sample counts, and an interval that is not quite right does not add up.
std::vector<double> counts_of(const std::vector<double>& t_s, double interval_s) {
  constexpr double follows = 0.1;  // share of a stamp's deviation
  std::vector<double> count{0};
  double expected = t_s.front();
  for (std::size_t i = 1; i < t_s.size(); ++i) {
    const double steps = std::max(1.0, std::round((t_s[i] - expected) / interval_s));
    count.push_back(count.back() + steps);
    expected += steps * interval_s;
    expected += follows * (t_s[i] - expected);
  }
  return count;
}

/// The straight line through stamps and counts.
EvenClock clock_through(const std::vector<double>& t_s, std::vector<double> count) {
  EvenClock out;
  out.count = std::move(count);
  const auto n = static_cast<double>(t_s.size());
  double mean_t = 0;
  double mean_count = 0;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    mean_t += (t_s[i] - t_s.front()) / n;
    mean_count += out.count[i] / n;
  }
  double along = 0;
  double square = 0;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    const double from_mean = out.count[i] - mean_count;
    along += from_mean * (t_s[i] - t_s.front() - mean_t);
    square += from_mean * from_mean;
  }
  out.interval_s = along / square;
  out.start_s = t_s.front() + mean_t - out.interval_s * mean_count;
  double squares = 0;
  for (std::size_t i = 0; i < t_s.size(); ++i) {
    squares += std::pow(t_s[i] - (out.start_s + out.interval_s * out.count[i]), 2);
  }
  out.scatter_s = std::sqrt(squares / n);
  return out;
}

/// Where samples were lost, the stamps tell which: a clock that scatters by more than a part of its
/// interval cannot. Where none was, each stamp is one further.
EvenClock clock_through(const std::vector<double>& t_s) {
  constexpr double most_of_none_lost = 0.35;  // of the interval; see check_clock_jitter() beyond
  std::vector<double> each(t_s.size());
  std::iota(each.begin(), each.end(), 0.0);
  EvenClock none_lost = clock_through(t_s, std::move(each));
  if (none_lost.scatter_s < most_of_none_lost * none_lost.interval_s) return none_lost;
  constexpr double most_of_some_lost = 0.15;
  EvenClock some_lost = clock_through(t_s, counts_of(t_s, statistics::even_interval(t_s)));
  if (some_lost.scatter_s > most_of_some_lost * some_lost.interval_s) some_lost.interval_s = 0;
  return some_lost;
}

/// Sum of squares by which samples lie off the straight line between their neighbours.
template <class Time>
double roughness(const std::vector<double>& q, const std::vector<double>& count, Time time) {
  double squares = 0;
  for (std::size_t i = 1; i + 1 < q.size(); ++i) {
    if (count[i + 1] - count[i - 1] != 2) continue;  // a sample is missing
    const double share = (time(i) - time(i - 1)) / (time(i + 1) - time(i - 1));
    squares += std::pow(q[i] - std::lerp(q[i - 1], q[i + 1], share), 2);
  }
  return squares;
}

/// The clock of the sampling, where the stamps are false.
std::optional<EvenClock> sampling_of(const joint::Recording& r) {
  constexpr std::size_t fewest_samples = 200;
  constexpr double least_scatter = 0.01;  // of the interval: no speed shows less
  constexpr double smoother = 0.5;
  if (r.size() < fewest_samples) return std::nullopt;
  EvenClock clock = clock_through(r.t_s);
  if (!(clock.interval_s > 0) || clock.scatter_s < least_scatter * clock.interval_s) {
    return std::nullopt;
  }
  const double by_stamps = roughness(r.q_rad, clock.count, [&](std::size_t i) { return r.t_s[i]; });
  const double by_clock =
      roughness(r.q_rad, clock.count, [&](std::size_t i) { return clock.count[i]; });
  if (!(by_clock < smoother * by_stamps)) return std::nullopt;
  return clock;
}

}  // namespace

bool has_false_stamps(const joint::Recording& recording) {
  return sampling_of(recording).has_value();
}

FalseStamps replace_false_stamps(std::vector<joint::Recording>& recordings) {
  FalseStamps out;
  for (joint::Recording& r : recordings) {
    const std::optional<EvenClock> clock = sampling_of(r);
    if (!clock) continue;
    for (std::size_t i = 0; i < r.size(); ++i) {
      r.t_s[i] = clock->start_s + clock->interval_s * clock->count[i];
    }
    out.replaced += r.size();
    const double percent = 100 * clock->scatter_s / clock->interval_s;
    if (percent < out.worst_percent) continue;
    out.worst_percent = percent;
    out.recording = r.name;
    out.interval_s = clock->interval_s;
  }
  return out;
}

}  // namespace tribolog::method::motion
