#include "ingest/log/row_clock.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

namespace tribolog::ingest::log {

std::string name_of_row_clock(double rate_Hz) { return fmt::format("row / {} Hz", rate_Hz); }

LogColumn row_clock(double rate_Hz, std::size_t rows) {
  LogColumn clock;
  clock.header.full = clock.header.name = name_of_row_clock(rate_Hz);
  clock.values.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) clock.values[i] = static_cast<double>(i) / rate_Hz;
  return clock;
}

void count_from_first(LogColumn& clock) {
  const auto first = std::find_if(clock.values.begin(), clock.values.end(),
                                  [](double value) { return !std::isnan(value); });
  if (first == clock.values.end()) return;
  if (clock.origin == 0 && std::abs(*first) < counts_from_1970) return;
  const double whole = std::floor(*first);
  clock.origin += whole;
  for (double& value : clock.values) value -= whole;
}

void add_to_clock(const LogColumn& part, double factor, LogColumn& clock) {
  count_from_first(clock);
  clock.origin += factor * part.origin;
  clock.gaps = 0;
  for (std::size_t row = 0; row < clock.values.size(); ++row) {
    clock.values[row] += factor * part.values[row];
    clock.gaps += std::isnan(clock.values[row]) ? 1 : 0;
  }
  count_from_first(clock);
}

double median_clock_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) steps.push_back(times[i] - times[i - 1]);
  }
  if (steps.empty()) return 0;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::size_t go_on_past_set_back(LogColumn& clock) {
  constexpr double least_steps = 20;      // back: less is jitter
  constexpr double of_another_log = 0.1;  // of the time before: it begins anew
  constexpr std::size_t most = 3;         // more alternate
  std::vector<double>& t = clock.values;
  const double step = median_clock_step(t);
  std::vector<std::size_t> backs;
  double before = NAN;
  double first = NAN;
  for (std::size_t row = 0; row < t.size(); ++row) {
    if (std::isnan(t[row])) continue;
    if (std::isnan(first)) first = t[row];
    if (before - t[row] > least_steps * step) {
      backs.push_back(row);
      if (backs.size() > most || t[row] - first < of_another_log * (before - first)) return 0;
    }
    before = t[row];
  }
  for (const std::size_t back : backs) {
    std::size_t last = back - 1;
    while (std::isnan(t[last])) --last;
    const double shift = t[last] - t[back] + step;
    for (std::size_t row = back; row < t.size(); ++row) t[row] += shift;
  }
  return backs.size();
}

std::size_t go_on_past_midnight(LogColumn& times_of_day) {
  constexpr double day_s = 86'400;
  std::size_t midnights = 0;
  double latest = NAN;
  for (double& value : times_of_day.values) {
    if (std::isnan(value)) continue;
    value += static_cast<double>(midnights) * day_s;
    if (latest - value > day_s / 2) {
      ++midnights;
      value += day_s;
    }
    latest = value;
  }
  return midnights;
}

}  // namespace tribolog::ingest::log
