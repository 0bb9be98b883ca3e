#include "history/slow_drift.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/normal.hpp>

#include "statistics/normal_score.h"

namespace tribolog::history {
namespace {

double square(double x) { return x * x; }

double mean(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double x : numbers) sum += x;
  return sum / static_cast<double>(numbers.size());
}

void centre(std::vector<double>& numbers) {
  const double middle = mean(numbers);
  for (double& x : numbers) x -= middle;
}

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// What is left of `numbers` beside a straight line over `over`; both centred.
void take_off(const std::vector<double>& over, std::vector<double>& numbers) {
  const double slope = product(over, numbers) / product(over, over);
  for (std::size_t k = 0; k < over.size(); ++k) numbers[k] -= slope * over[k];
}

/// The line over the first `count` of the series.
std::optional<SlowDrift> line_over(const std::vector<SeriesPoint>& series,
                                   const std::vector<double>& days, bool with_temperature,
                                   std::size_t count) {
  constexpr double least_share_of_time = 0.05;  // that temperature leaves
  std::vector<double> values, times, temperatures;
  for (std::size_t k = 0; k < count; ++k) {
    values.push_back(series[k].value);
    times.push_back(days[k]);
    temperatures.push_back(series[k].temperature_C);
  }
  const double level = mean(values);
  const double middle = mean(times);
  centre(values);
  centre(times);
  centre(temperatures);
  const double spread_of_time = product(times, times);
  // Frisch and Waugh: the slope over time with temperature in the model is that of what
  // temperature leaves of both.
  if (with_temperature && product(temperatures, temperatures) > 0) {
    take_off(temperatures, values);
    take_off(temperatures, times);
  }
  const double spread = product(times, times);
  if (!(spread > square(least_share_of_time) * spread_of_time)) return std::nullopt;
  SlowDrift drift;
  drift.freedom = static_cast<double>(count) - (with_temperature ? 3 : 2);
  drift.per_day = product(times, values) / spread;
  const double rest = product(values, values) - square(drift.per_day) * spread;
  drift.standard_error = std::sqrt(std::max(0.0, rest) / drift.freedom / spread);
  drift.at_start = level + drift.per_day * (days.front() - middle);
  drift.score = normal_score(drift.per_day / drift.standard_error, drift.freedom);
  return drift;
}

}  // namespace

double drift_limit(std::size_t watched) {
  const double tail =
      drift_false_alarms / 2 / static_cast<double>(std::max<std::size_t>(watched, 1));
  return -boost::math::quantile(boost::math::normal(), tail);
}

std::optional<SlowDrift> find_slow_drift(const std::vector<SeriesPoint>& series,
                                         const std::vector<double>& days, bool with_temperature,
                                         std::size_t watched) {
  const double limit = drift_limit(watched);
  std::optional<SlowDrift> told;
  // From the last calibration back, as long as it was told at each of them.
  for (std::size_t count = series.size(); count >= fewest_for_drift; --count) {
    const auto line = line_over(series, days, with_temperature, count);
    const bool is_told =
        line && std::abs(line->score) >= limit && (!told || (line->score > 0) == (told->score > 0));
    if (!is_told) break;
    if (!told) told = line;
    told->visible = count - 1;
  }
  return told;
}

}  // namespace tribolog::history
