// The clock of the log: how even it is, and what is missing.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"

namespace tribolog {
namespace {

constexpr double gap_intervals = 5;  ///< From so many sampling intervals on it is a gap.

const char* const words_of_consequence =
    "speed and acceleration are differences of the angle over the clock, and are wrong with it";

struct Clock {
  double jitter_percent{};
  double missing_percent{};
  double longest_gap_s{};
  std::size_t gaps{};
};

Clock clock_of(const CheckedRecording& r) {
  Clock clock;
  const std::vector<double>& t = r.recording->t_s;
  if (t.size() < 3) return clock;
  double squares = 0;
  double missing = 0;
  std::size_t regular = 0;
  for (std::size_t i = 1; i < t.size(); ++i) {
    const double interval = t[i] - t[i - 1];
    if (interval > gap_intervals * r.interval_s) {
      ++clock.gaps;
      missing += interval - r.interval_s;
      clock.longest_gap_s = std::max(clock.longest_gap_s, interval);
      continue;
    }
    squares += std::pow(interval / r.interval_s - 1, 2);
    ++regular;
  }
  clock.jitter_percent =
      100 * std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, regular)));
  clock.missing_percent = 100 * missing / (t.back() - t.front());
  return clock;
}

}  // namespace

DataCheck check_clock_jitter(const CheckedDataset& data) {
  // An interval that scatters by half of itself is no clock that a speed can be taken from; logs
  // over a network scatter by some ten per cent.
  constexpr double most_percent = 50;
  DataCheck check;
  check.name = "clock_jitter";
  check.title = "Even clock";
  check.measure = "scatter of the sampling interval";
  check.unit = percent_sign;
  check.at_most = most_percent;
  double interval = 0;
  for (const CheckedRecording& r : data.recordings) {
    const double jitter = clock_of(r).jitter_percent;
    if (!take_if_worst(check, jitter, r.recording->name)) continue;
    interval = r.interval_s;
  }
  if (!check.measured) return not_applicable(check.name, check.title, "no recording");
  check.found = fmt::format("the interval of {:.4g} ms scatters by {:.1f} % of itself",
                            1e3 * interval, *check.measured);
  check.state = passed_or_fails(check);
  if (check.state == CheckState::passed) return check;
  check.consequence = words_of_consequence;
  check.experiment =
      "log the time at which the drive sampled, not the time at which the row was "
      "written";
  return check;
}

DataCheck check_clock_gaps(const CheckedDataset& data) {
  constexpr double most_percent = 5;
  DataCheck check;
  check.name = "clock_gaps";
  check.title = "No gaps in time";
  check.measure = "time lost in gaps";
  check.unit = percent_sign;
  check.at_most = most_percent;
  Clock worst;
  for (const CheckedRecording& r : data.recordings) {
    const Clock clock = clock_of(r);
    if (!take_if_worst(check, clock.missing_percent, r.recording->name)) continue;
    worst = clock;
  }
  if (!check.measured) return not_applicable(check.name, check.title, "no recording");
  if (worst.gaps == 0) {
    return passed_by_all(
        check, fmt::format("no interval is longer than {} sampling intervals", gap_intervals));
  }
  check.found = fmt::format("{} gap{}, the longest {:.3g} s", worst.gaps,
                            worst.gaps == 1 ? "" : "s", worst.longest_gap_s);
  check.state = *check.measured <= most_percent ? CheckState::warns : CheckState::fails;
  check.consequence =
      "what happened in the gaps is unknown: a reversal or a settling may be "
      "missing, and slopes across a gap are no speeds";
  check.experiment =
      "log locally in the controller, or at a lower rate that the connection carries";
  return check;
}

}  // namespace tribolog
