#include "history/reference_line.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/normal.hpp>

#include "statistics/distributions.h"

namespace tribolog::history {

namespace {

/// No calibration resolves less than this share of a value.
constexpr double finest_share = 1e-6;

double square(double x) { return x * x; }

/// Least squares, weighted by the variances that the line has already, or all alike.
void solve(const std::vector<SeriesPoint>& points, const std::vector<std::size_t>& members,
           bool with_slope, bool is_weighted, ReferenceLine& line) {
  double sum = 0, value = 0, temperature = 0;
  const auto weight = [&](const SeriesPoint& p) {
    return is_weighted ? 1 / line.variance_of(p.standard_error) : 1.0;
  };
  for (const std::size_t k : members) {
    sum += weight(points[k]);
    value += weight(points[k]) * points[k].value;
    temperature += weight(points[k]) * points[k].temperature_C;
  }
  line.level = value / sum;
  line.mean_temperature_C = temperature / sum;
  line.level_variance = 1 / sum;
  if (!with_slope) return;
  double spread = 0, product = 0;
  for (const std::size_t k : members) {
    const double away = points[k].temperature_C - line.mean_temperature_C;
    spread += weight(points[k]) * square(away);
    product += weight(points[k]) * away * (points[k].value - line.level);
  }
  line.slope_per_K = product / spread;
  line.slope_variance = 1 / spread;
}

/// Sum of the squared differences of successive residuals.
double moving_ranges(const std::vector<SeriesPoint>& points,
                     const std::vector<std::size_t>& members, const ReferenceLine& line) {
  double sum = 0;
  for (std::size_t k = 1; k < members.size(); ++k) {
    const SeriesPoint& a = points[members[k - 1]];
    const SeriesPoint& b = points[members[k]];
    sum += square(b.value - a.value - line.slope_per_K * (b.temperature_C - a.temperature_C));
  }
  return sum;
}

bool have_two_temperatures(const std::vector<SeriesPoint>& points,
                           const std::vector<std::size_t>& members) {
  constexpr double same_K = 1e-3;
  const double first = points[members.front()].temperature_C;
  return std::any_of(members.begin(), members.end(), [&](std::size_t k) {
    return std::abs(points[k].temperature_C - first) > same_K;
  });
}

}  // namespace

std::optional<ReferenceLine> ReferenceLine::fitted(const std::vector<SeriesPoint>& points,
                                                   const std::vector<std::size_t>& members,
                                                   bool with_slope) {
  const std::size_t parameters = with_slope ? 2 : 1;
  if (members.size() < parameters + 2) return std::nullopt;
  if (with_slope && !have_two_temperatures(points, members)) return std::nullopt;
  ReferenceLine line;
  line.members = members.size();
  solve(points, members, with_slope, false, line);
  const auto m = static_cast<double>(members.size());
  const auto p = static_cast<double>(parameters);
  for (const std::size_t k : members) line.stated_variance += square(points[k].standard_error) / m;
  const double floor = square(finest_share * line.level);
  const double total = moving_ranges(points, members, line) / (2 * (m - p));
  line.between_variance = std::max(floor, total - line.stated_variance);
  line.stated_share = total < line.stated_variance ? total / line.stated_variance : 1;
  // The distribution of the mean square successive difference, as a chi-square of equal moments.
  line.freedom = 2 * square(m - 1) / (3 * m - 4) - (p - 1);
  solve(points, members, with_slope, true, line);
  return line;
}

Expectation ReferenceLine::at(double temperature_C) const {
  if (slope_variance == 0) return {level, level_variance};
  const double away = temperature_C - mean_temperature_C;
  return {level + slope_per_K * away, level_variance + square(away) * slope_variance};
}

double ReferenceLine::variance_of(double standard_error) const {
  return stated_share * square(standard_error) + between_variance;
}

double ReferenceLine::standardised(const SeriesPoint& point) const {
  const Expectation expected = at(point.temperature_C);
  return (point.value - expected.value) /
         std::sqrt(variance_of(point.standard_error) + expected.variance);
}

double ReferenceLine::scatter() const {
  return std::sqrt(between_variance + stated_share * stated_variance);
}

namespace {

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
  drift.score = statistics::normal_score(drift.per_day / drift.standard_error, drift.freedom);
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
  std::optional<SlowDrift> drift;
  // From the last calibration back, as long as each of them would have reported it.
  for (std::size_t count = series.size(); count >= fewest_for_drift; --count) {
    const auto line = line_over(series, days, with_temperature, count);
    const bool is_seen = line && std::abs(line->score) >= limit &&
                         (!drift || (line->score > 0) == (drift->score > 0));
    if (!is_seen) break;
    if (!drift) drift = line;
    drift->visible = count - 1;
  }
  return drift;
}

}  // namespace tribolog::history
