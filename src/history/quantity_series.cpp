#include "history/quantity_series.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "history/quantity_traits.h"
#include "statistics/distributions.h"

namespace tribolog::history {
namespace {

using calibration::Facts;
using calibration::Measured;
using calibration::Quantity;

LeftOut left_out(const calibration::Quantity& q, const calibration::Facts& facts,
                 const calibration::Facts& latest, const std::string& from) {
  if (facts.measured_at < from) return LeftOut::before_baseline;
  if (q.verdict != calibration::Verdict::usable) return LeftOut::not_usable;
  if (!has_same_gear(facts, latest)) return LeftOut::other_gear;
  if (traits_of(q.name).depends_on_payload && !has_same_payload(facts, latest)) {
    return LeftOut::other_payload;
  }
  return LeftOut::none;
}

bool has_value(const calibration::Quantity& q) {
  return q.estimate && std::isfinite(q.estimate->value);
}

/// The unit of each quantity in the latest calibration that has an estimate of it.
std::map<std::string, std::string> latest_units(
    const std::vector<calibration::Measured>& calibrations) {
  std::map<std::string, std::string> units;
  for (const calibration::Measured& m : calibrations) {
    for (const calibration::Quantity& q : m.quantities) {
      if (has_value(q)) units[q.name] = q.unit;
    }
  }
  return units;
}

void add(const calibration::Quantity& q, const calibration::Entry& entry, LeftOut why,
         const std::map<std::string, std::string>& units, std::vector<QuantityTrend>& all) {
  auto at = std::find_if(all.begin(), all.end(),
                         [&](const QuantityTrend& t) { return t.name == q.name; });
  if (at == all.end()) {
    all.emplace_back();
    at = all.end() - 1;
    at->name = q.name;
    at->words = q.words;
    const auto unit = units.find(q.name);
    at->unit = unit == units.end() ? q.unit : unit->second;
  }
  if (!has_value(q)) {
    ++at->without_estimate;
    return;
  }
  if (q.unit != at->unit) {
    ++at->in_another_unit;
    return;
  }
  HistoryPoint point;
  point.id = entry.id;
  point.measured_at = entry.facts.measured_at;
  point.estimate = *q.estimate;
  point.temperature_C = entry.facts.temperature_C;
  point.left_out = why;
  at->points.push_back(std::move(point));
}

/// Decides from what was recorded alone, never from the values.
void decide_on_temperature(QuantityTrend& trend) {
  if (!traits_of(trend.name).depends_on_temperature) {
    trend.temperature = TemperatureUse::hardly_felt;
    return;
  }
  std::vector<double> known;
  std::size_t charted = 0;
  for (const HistoryPoint& p : trend.points) {
    if (p.left_out != LeftOut::none) continue;
    ++charted;
    if (p.temperature_C) known.push_back(*p.temperature_C);
  }
  if (known.empty() || 2 * known.size() < charted) return;
  const auto [low, high] = std::minmax_element(known.begin(), known.end());
  if (*high - *low < least_temperature_span_K) {
    trend.temperature = TemperatureUse::too_even;
    return;
  }
  trend.temperature = TemperatureUse::corrected;
  for (HistoryPoint& p : trend.points) {
    if (p.left_out == LeftOut::none && !p.temperature_C) p.left_out = LeftOut::no_temperature;
  }
}

}  // namespace

std::vector<QuantityTrend> quantity_series(const std::vector<calibration::Measured>& calibrations,
                                           const std::string& from) {
  std::vector<QuantityTrend> all;
  const calibration::Facts& latest = calibrations.back().entry.facts;
  const std::map<std::string, std::string> units = latest_units(calibrations);
  for (const calibration::Measured& m : calibrations) {
    for (const calibration::Quantity& q : m.quantities) {
      add(q, m.entry, left_out(q, m.entry.facts, latest, from), units, all);
    }
  }
  std::erase_if(all, [](const QuantityTrend& t) { return t.points.empty(); });
  for (QuantityTrend& trend : all) {
    if (traits_of(trend.name).is_angle) {
      // On the circle about the first.
      const double about = trend.points.front().estimate.value;
      for (HistoryPoint& p : trend.points) {
        const double turned =
            about + std::remainder(p.estimate.value - about, 2 * std::numbers::pi);
        const double by = turned - p.estimate.value;
        p.estimate.value += by;
        p.estimate.low += by;
        p.estimate.high += by;
      }
    }
    decide_on_temperature(trend);
  }
  return all;
}

SeriesPoint series_point(const HistoryPoint& point) {
  const double half_width = (point.estimate.high - point.estimate.low) / 2;
  return {point.estimate.value, half_width / statistics::normal_975,
          point.temperature_C.value_or(0)};
}

Statement caution_on_warming(const std::vector<calibration::Measured>& calibrations) {
  constexpr double strong = 0.9;
  double n = 0, t = 0, x = 0, tt = 0, xx = 0, tx = 0;
  double low = 0, high = 0;
  for (std::size_t k = 0; k < calibrations.size(); ++k) {
    const auto& temperature = calibrations[k].entry.facts.temperature_C;
    if (!temperature) continue;
    low = n == 0 ? *temperature : std::min(low, *temperature);
    high = n == 0 ? *temperature : std::max(high, *temperature);
    const auto order = static_cast<double>(k);
    n += 1, t += *temperature, x += order;
    tt += *temperature * *temperature, xx += order * order, tx += *temperature * order;
  }
  if (n <= fewest_learned || high - low < least_temperature_span_K) return {};
  const double correlation = (tx - t * x / n) / std::sqrt((tt - t * t / n) * (xx - x * x / n));
  if (!(std::abs(correlation) > strong)) return {};
  return {"trend.warming", {{"correlation", correlation}}};
}

}  // namespace tribolog::history
