#include "history/reference_line.h"

#include <algorithm>
#include <cmath>

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

}  // namespace tribolog::history
