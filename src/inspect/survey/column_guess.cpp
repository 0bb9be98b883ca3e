#include "inspect/survey/column_guess.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "base/closest_match.h"

namespace tribolog::inspect::survey {
namespace {

constexpr double widest_rad = 4 * 3.14159265358979;  // two turns; more are degrees
constexpr double rising_share = 0.95;
constexpr double fewest_rows = 20;
constexpr double least_correlation = 0.95;

/// A clock may stand or jump now and then, but rises.
bool looks_like_clock(const std::vector<double>& values) {
  if (static_cast<double>(values.size()) < fewest_rows) return false;
  std::size_t rising = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1]) ++rising;
  }
  return static_cast<double>(rising) >= rising_share * static_cast<double>(values.size() - 1);
}

/// How a column goes with the slope of another.
struct SlopeFit {
  double correlation{std::numeric_limits<double>::quiet_NaN()};  ///< NaN where either stands still.
  double ratio{};  ///< The column over the slope, by least squares.
};

SlopeFit fit_slope(const std::vector<double>& t, const std::vector<double>& y,
                   const std::vector<double>& v) {
  // Over several samples, or steps of the encoder drown the slope.
  constexpr std::size_t half = 5;
  constexpr std::size_t most_samples = 20000;  // of a long log, spread over it
  const std::size_t step = std::max<std::size_t>(1, t.size() / most_samples);
  std::vector<double> slopes;
  std::vector<double> speeds;
  for (std::size_t i = half; i + half < t.size(); i += step) {
    const double slope = (y[i + half] - y[i - half]) / (t[i + half] - t[i - half]);
    if (!std::isfinite(slope) || !std::isfinite(v[i])) continue;
    // Counted from the first: a column that stands still is then exactly zero.
    slopes.push_back(slope - (slopes.empty() ? 0 : slopes.front()));
    speeds.push_back(v[i] - (speeds.empty() ? 0 : speeds.front()));
  }
  if (slopes.empty()) return {};
  slopes.front() = 0;
  speeds.front() = 0;
  const auto n = static_cast<double>(slopes.size());
  const double x_mean = std::accumulate(slopes.begin(), slopes.end(), 0.0) / n;
  const double y_mean = std::accumulate(speeds.begin(), speeds.end(), 0.0) / n;
  double xx = 0;
  double yy = 0;
  double xy = 0;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    xx += (slopes[i] - x_mean) * (slopes[i] - x_mean);
    yy += (speeds[i] - y_mean) * (speeds[i] - y_mean);
    xy += (slopes[i] - x_mean) * (speeds[i] - y_mean);
  }
  return {xy / std::sqrt(xx * yy), xy / xx};
}

bool has(const ingest::layout::LogLayout& layout, ingest::log::Quantity quantity) {
  return std::any_of(layout.columns.begin(), layout.columns.end(),
                     [&](const ingest::layout::ColumnMeaning& c) {
                       return c.quantity == quantity && !c.is_target;
                     });
}

bool is_told(const ingest::layout::LogLayout& layout, std::size_t column) {
  return std::any_of(layout.columns.begin(), layout.columns.end(),
                     [&](const ingest::layout::ColumnMeaning& c) { return c.column == column; }) ||
         std::any_of(layout.foreign.begin(), layout.foreign.end(),
                     [&](const ingest::layout::ForeignUnit& f) { return f.column == column; });
}

GuessedMeaning meaning_of(std::size_t column, ingest::log::Quantity quantity, std::string unit,
                          std::string reason) {
  GuessedMeaning guess;
  guess.meaning.column = column;
  guess.meaning.quantity = quantity;
  guess.meaning.unit = std::move(unit);
  guess.reason = std::move(reason);
  return guess;
}

/// Groups as far apart as a joint's angle and speed, in columns without names behind the clock.
std::optional<ColumnGroups> groups_of(const ingest::log::LogTable& table, std::size_t clock,
                                      std::size_t angle, std::size_t speed) {
  constexpr std::size_t fewest_groups = 3;  // two may be one joint's columns in another order
  if (speed < angle + 2 || !table.columns[angle].header.full.starts_with('#')) return std::nullopt;
  const ColumnGroups groups{clock < angle ? clock + 1 : 0, speed - angle};
  const std::size_t end = clock < angle ? table.columns.size() : clock;
  const bool is_in_first = angle >= groups.first && angle < groups.first + groups.joints;
  const std::size_t columns = end - groups.first;
  if (!is_in_first || columns % groups.joints != 0) return std::nullopt;
  return columns / groups.joints >= fewest_groups ? std::optional(groups) : std::nullopt;
}

/// Of two columns as they are; NaN where either stands still.
double correlation_of(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0;
  double x_sum = 0;
  double y_sum = 0;
  const auto is_there = [&](std::size_t i) { return std::isfinite(x[i]) && std::isfinite(y[i]); };
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_there(i)) continue;
    ++n;
    x_sum += x[i];
    y_sum += y[i];
  }
  double xx = 0;
  double yy = 0;
  double xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_there(i)) continue;
    xx += (x[i] - x_sum / n) * (x[i] - x_sum / n);
    yy += (y[i] - y_sum / n) * (y[i] - y_sum / n);
    xy += (x[i] - x_sum / n) * (y[i] - y_sum / n);
  }
  return xy / std::sqrt(xx * yy);
}

double range_of(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high > low ? high - low : 0;
}

}  // namespace

std::optional<std::size_t> first_effort_by_place(const ingest::log::LogTable& table,
                                                 std::size_t clock, const ColumnGroups& groups) {
  constexpr double as_set_points = 0.995;
  constexpr double as_accelerations = 0.8;
  const auto values = [&](std::size_t k) -> const std::vector<double>& {
    return table.columns[k].values;
  };
  std::size_t joint = 0;
  for (std::size_t k = 0; k < groups.joints; ++k) {
    const bool is_wider =
        range_of(values(groups.first + k)) > range_of(values(groups.first + joint));
    if (is_wider) joint = k;
  }
  const std::vector<double>& angle = values(groups.first + joint);
  const std::vector<double>& speed = values(groups.first + groups.joints + joint);
  for (std::size_t begin = groups.first + 2 * groups.joints;
       begin + groups.joints <= table.columns.size(); begin += groups.joints) {
    if (clock >= begin && clock < begin + groups.joints) break;
    const std::vector<double>& one = values(begin + joint);
    const bool is_number =
        table.columns[begin + joint].reading == ingest::log::ColumnReading::number;
    const bool is_set_point = std::abs(correlation_of(one, angle)) > as_set_points ||
                              std::abs(correlation_of(one, speed)) > as_set_points;
    const bool is_acceleration =
        std::abs(fit_slope(values(clock), speed, one).correlation) > as_accelerations;
    if (is_number && range_of(one) > 0 && !is_set_point && !is_acceleration) return begin;
  }
  return std::nullopt;
}

std::string ColumnGroups::joint_of(std::size_t column) const {
  return std::to_string((column - first) % joints + 1);
}

bool looks_like_counter(const std::vector<double>& values) {
  std::size_t steps = 0;
  std::size_t by_one = 0;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (value != std::floor(value)) return false;
    if (std::isfinite(before)) ++steps;
    if (value - before == 1) ++by_one;
    before = value;
  }
  return steps > 0 && static_cast<double>(by_one) >= rising_share * static_cast<double>(steps);
}

std::optional<double> speed_by_slope(const std::vector<double>& t_s,
                                     const std::vector<double>& angle,
                                     const std::vector<double>& speed) {
  const SlopeFit fit = fit_slope(t_s, angle, speed);
  return std::abs(fit.correlation) > least_correlation ? std::optional(fit.ratio) : std::nullopt;
}

bool looks_like_degrees(const std::vector<double>& angles, double gear_ratio) {
  double low = INFINITY;
  double high = -INFINITY;
  for (const double q : angles) {
    if (!std::isfinite(q)) continue;
    low = std::min(low, q);
    high = std::max(high, q);
  }
  return high - low > widest_rad * std::abs(gear_ratio);
}

GuessedLayout guess_by_numbers(const ingest::log::LogTable& table,
                               const ingest::layout::LogLayout& layout) {
  GuessedLayout out;
  std::vector<GuessedMeaning>& guesses = out.meanings;
  const auto& columns = table.columns;
  std::optional<std::size_t> clock;
  for (const ingest::layout::ColumnMeaning& c : layout.columns) {
    if (c.quantity == ingest::log::Quantity::time) clock = c.column;
  }
  for (std::size_t k = 0; k < columns.size() && !clock; ++k) {
    const bool may_be = columns[k].reading == ingest::log::ColumnReading::number &&
                        !looks_like_counter(columns[k].values);
    if (is_told(layout, k) || !may_be || !looks_like_clock(columns[k].values)) continue;
    clock = k;
    guesses.push_back(
        meaning_of(k, ingest::log::Quantity::time, "s", "the first column that only rises"));
  }
  if (!clock || has(layout, ingest::log::Quantity::angle)) return out;
  const auto correlation = [&](std::size_t a, std::size_t v) {
    const bool are_numbers = columns[a].reading == ingest::log::ColumnReading::number &&
                             columns[v].reading == ingest::log::ColumnReading::number;
    const bool may_be = are_numbers && a != v && a != *clock && v != *clock && !is_told(layout, a);
    return may_be
               ? fit_slope(columns[*clock].values, columns[a].values, columns[v].values).correlation
               : std::numeric_limits<double>::quiet_NaN();
  };
  double best = least_correlation;
  std::size_t angle = 0;
  std::size_t speed = 0;
  for (std::size_t a = 0; a < columns.size(); ++a) {
    for (std::size_t v = 0; v < columns.size(); ++v) {
      const double r = correlation(a, v);
      if (!(r > best)) continue;
      best = r;
      angle = a;
      speed = v;
    }
  }
  // Speed and acceleration go together as angle and speed do.
  for (std::size_t a = 0; a < columns.size() && angle != speed; ++a) {
    if (a == speed || !(correlation(a, angle) > least_correlation)) continue;
    speed = angle;
    angle = a;
    break;
  }
  if (angle == speed) return out;
  out.groups = groups_of(table, *clock, angle, speed);
  guesses.push_back(meaning_of(angle, ingest::log::Quantity::angle, "rad",
                               "its slope is column " + in_quotes(columns[speed].header.full)));
  if (!is_told(layout, speed)) {
    guesses.push_back(
        meaning_of(speed, ingest::log::Quantity::angular_speed, "rad/s",
                   "it is the slope of column " + in_quotes(columns[angle].header.full)));
  }
  if (!out.groups) return out;
  for (GuessedMeaning& guess : guesses) {
    if (guess.meaning.column != *clock) {
      guess.meaning.joint = out.groups->joint_of(guess.meaning.column);
    }
  }
  for (std::size_t k = 0; k < out.groups->joints; ++k) {
    const std::size_t q = out.groups->first + k;
    const std::size_t v = q + out.groups->joints;
    if (q == angle || is_told(layout, q) || is_told(layout, v)) continue;
    const std::string place = "by its place, as " + in_quotes(columns[angle].header.full) +
                              " and " + in_quotes(columns[speed].header.full);
    guesses.push_back(meaning_of(q, ingest::log::Quantity::angle, "rad", place));
    guesses.back().meaning.joint = out.groups->joint_of(q);
    guesses.push_back(meaning_of(v, ingest::log::Quantity::angular_speed, "rad/s", place));
    guesses.back().meaning.joint = out.groups->joint_of(v);
  }
  return out;
}

}  // namespace tribolog::inspect::survey
