#include "history/joint_trend.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "calibration/read_calibration.h"
#include "history/quantity_series.h"
#include "history/quantity_traits.h"
#include "history/reference_line.h"
#include "statistics/distributions.h"

namespace tribolog::history {
namespace {

using calibration::Measured;

/// Times between which the baseline lies, as measured_at has them.
struct BaselineTimes {
  std::string from;
  std::string to;
};

std::string time_of(const std::string& text, const char* end_of_day) {
  if (text.empty()) return "";
  const bool is_day = text.size() == std::string("2026-01-31").size();
  const std::string time = calibration::utc_of_iso_text(is_day ? text + end_of_day : text);
  if (time.empty()) {
    throw UsageError("the baseline's date " + printable(text) + " is none; 2026-01-31 is one");
  }
  return time;
}

BaselineTimes times_of(const Baseline& baseline) {
  if (!baseline.is_by_date() && baseline.count < fewest_learned) {
    throw UsageError(
        fmt::format("a baseline of {} calibrations is too short; at least {} tell "
                    "their scatter",
                    baseline.count, fewest_learned));
  }
  return {time_of(baseline.from, "T00:00:00Z"), time_of(baseline.to, "T23:59:59Z")};
}

/// How many of the first charted points the baseline holds.
std::size_t learned_count(const std::vector<const HistoryPoint*>& charted, const Baseline& baseline,
                          const BaselineTimes& times) {
  if (!baseline.is_by_date()) return baseline.count;
  const auto inside = std::count_if(charted.begin(), charted.end(), [&](const HistoryPoint* p) {
    return times.to.empty() || p->measured_at <= times.to;
  });
  return std::max<std::size_t>(static_cast<std::size_t>(inside), fewest_learned);
}

/// Of a reference that is not zero beyond doubt.
std::optional<double> percent_of(const ReferenceLine& reference, double size) {
  if (!(std::abs(reference.level) > 2 * std::sqrt(reference.level_variance))) return std::nullopt;
  return 100 * size / std::abs(reference.level);
}

FoundChange found_change(const std::vector<const HistoryPoint*>& charted, const Excursion& e,
                         const ReferenceLine& reference) {
  constexpr std::size_t latest = 3;
  const std::size_t end = e.back.value_or(charted.size());
  const std::size_t begin = std::max(e.start, end > latest ? end - latest : 0);
  double mean = 0, variance = 0, expectation = 0;
  const auto n = static_cast<double>(end - begin);
  for (std::size_t k = begin; k < end; ++k) {
    const SeriesPoint point = series_point(*charted[k]);
    const Expectation expected = reference.at(point.temperature_C);
    mean += (point.value - expected.value) / n;
    variance += reference.variance_of(point.standard_error) / (n * n);
    expectation += expected.variance / n;
  }
  const double half_width =
      statistics::student_t_975(reference.freedom) * std::sqrt(variance + expectation);
  FoundChange change;
  change.direction = e.direction;
  change.from = charted[e.start]->measured_at;
  change.alarm = charted[e.alarm]->measured_at;
  if (e.back) change.back = charted[*e.back]->measured_at;
  change.calibrations_to_alarm = e.alarm - e.start + 1;
  change.size =
      statistics::symmetric_estimate(mean, half_width, {"interval.last_three_against_reference"});
  change.percent = percent_of(reference, mean);
  return change;
}

std::vector<FoundApart> found_apart(const std::vector<const HistoryPoint*>& charted,
                                    const ControlChart& chart, const ReferenceLine& reference) {
  std::vector<FoundApart> found;
  for (std::size_t k = 0; k < charted.size(); ++k) {
    const bool is_in_change = std::any_of(
        chart.excursions.begin(), chart.excursions.end(),
        [&](const Excursion& e) { return k >= e.start && k < e.back.value_or(charted.size()); });
    if (!chart.points[k].is_apart || is_in_change) continue;
    const SeriesPoint point = series_point(*charted[k]);
    FoundApart one;
    one.at = charted[k]->measured_at;
    one.size = point.value - reference.at(point.temperature_C).value;
    one.percent = percent_of(reference, one.size);
    one.is_latest = k + 1 == charted.size();
    found.push_back(std::move(one));
  }
  return found;
}

/// 1970-01-01: 0.
double day_number(const HistoryPoint& point) {
  constexpr double seconds = 86400;
  return calibration::seconds_of_utc(point.measured_at) / seconds;
}

FoundChange found_drift(const std::vector<const HistoryPoint*>& charted, const SlowDrift& drift) {
  const double span = day_number(*charted.back()) - day_number(*charted.front());
  FoundChange change;
  change.is_slow = true;
  change.direction = drift.score > 0 ? 1 : -1;
  change.from = charted.front()->measured_at;
  change.alarm = charted[drift.visible]->measured_at;
  change.calibrations_to_alarm = drift.visible + 1;
  change.size = statistics::symmetric_estimate(
      drift.per_day * span, statistics::student_t_975(drift.freedom) * drift.standard_error * span,
      {"interval.line_over_calibrations"});
  change.drift_start = drift.at_start;
  change.drift_days = span;
  if (std::abs(drift.at_start) > std::abs(change.size.value)) {
    change.percent = 100 * change.size.value / std::abs(drift.at_start);
  }
  return change;
}

/// Whether a straight line over all calibrations describes them better than one mean before a shift
/// and another from it on. The values are brought to one temperature.
bool is_nearer_to_a_line(const std::vector<const HistoryPoint*>& charted,
                         const std::vector<double>& days, std::size_t shift) {
  const auto value = [&](std::size_t k) {
    return charted[k]->corrected.value_or(charted[k]->estimate.value);
  };
  const auto squares_about = [&](std::size_t begin, std::size_t end, bool with_slope) {
    const auto n = static_cast<double>(end - begin);
    double day = 0, mean = 0;
    for (std::size_t k = begin; k < end; ++k) day += days[k] / n, mean += value(k) / n;
    double dd = 0, dv = 0, vv = 0;
    for (std::size_t k = begin; k < end; ++k) {
      dd += (days[k] - day) * (days[k] - day);
      dv += (days[k] - day) * (value(k) - mean);
      vv += (value(k) - mean) * (value(k) - mean);
    }
    return with_slope && dd > 0 ? vv - dv * dv / dd : vv;
  };
  const std::size_t all = charted.size();
  return squares_about(0, all, true) <
         squares_about(0, shift, false) + squares_about(shift, all, false);
}

void chart(QuantityTrend& trend, const Baseline& baseline, const BaselineTimes& times,
           std::size_t watched) {
  std::vector<HistoryPoint*> charted;
  for (HistoryPoint& p : trend.points) {
    if (p.left_out == LeftOut::none) charted.push_back(&p);
  }
  const std::vector<const HistoryPoint*> shown(charted.begin(), charted.end());
  std::vector<SeriesPoint> series;
  for (const HistoryPoint* p : shown) series.push_back(series_point(*p));
  ChartSettings settings;
  settings.learned = learned_count(shown, baseline, times);
  settings.watched = watched;
  settings.with_slope = trend.temperature == TemperatureUse::corrected;
  const ControlChart made = make_control_chart(series, settings);
  trend.limit = made.limit;
  trend.reference = made.reference;
  trend.judged = made.judged();
  trend.learned = charted.size() - trend.judged;
  for (std::size_t k = 0; k < charted.size(); ++k) {
    charted[k]->chart = made.points[k];
    if (!made.reference) continue;
    const double away = series[k].temperature_C - made.reference->mean_temperature_C;
    charted[k]->corrected = series[k].value - made.reference->slope_per_K * away;
  }
  if (trend.judged == 0 || !made.reference) return;
  for (const Excursion& e : made.excursions) {
    trend.changes.push_back(found_change(shown, e, *made.reference));
  }
  trend.apart = found_apart(shown, made, *made.reference);
  std::vector<double> days;
  for (const HistoryPoint* p : shown) days.push_back(day_number(*p));
  const auto drift = find_slow_drift(series, days, settings.with_slope, watched);
  const bool is_one_shift = made.excursions.size() == 1 && !made.excursions.front().back;
  if (drift && is_one_shift && is_nearer_to_a_line(shown, days, made.excursions.front().start)) {
    trend.changes.clear();
  } else if (!made.excursions.empty()) {
    trend.state = made.warning() != nullptr ? TrendState::warning : TrendState::recovered;
    return;
  }
  if (drift) {
    trend.changes.push_back(found_drift(shown, *drift));
    // The chart may have seen it before there were enough calibrations for a line.
    for (const Excursion& e : made.excursions) {
      std::string& alarm = trend.changes.back().alarm;
      alarm = std::min(alarm, shown[e.alarm]->measured_at);
    }
  }
  if (drift) {
    trend.state = TrendState::warning;
  } else {
    trend.state = trend.apart.empty() ? TrendState::steady : TrendState::apart;
  }
}

std::vector<Statement> cautions_on(const std::vector<calibration::Measured>& calibrations) {
  std::vector<Statement> cautions;
  const auto without_time =
      std::count_if(calibrations.begin(), calibrations.end(),
                    [](const calibration::Measured& m) { return !m.entry.facts.time_is_stated; });
  if (without_time > 0) {
    cautions.push_back({"trend.time_not_stated",
                        {{"undated", without_time}, {"calibrations", calibrations.size()}}});
  }
  if (const Statement warming = caution_on_warming(calibrations); !warming.empty()) {
    cautions.push_back(warming);
  }
  return cautions;
}

JointTrend trend_of(std::vector<calibration::Measured> calibrations, const Baseline& baseline,
                    const BaselineTimes& times) {
  std::stable_sort(calibrations.begin(), calibrations.end(),
                   [](const calibration::Measured& a, const calibration::Measured& b) {
                     return a.entry.facts.measured_at < b.entry.facts.measured_at;
                   });
  JointTrend trend;
  trend.of = calibrations.front().entry.facts.of;
  trend.calibrations = calibrations.size();
  trend.first_at = calibrations.front().entry.facts.measured_at;
  trend.last_at = calibrations.back().entry.facts.measured_at;
  trend.baseline = baseline;
  trend.cautions = cautions_on(calibrations);
  trend.quantities = quantity_series(calibrations, times.from);
  for (const QuantityTrend& q : trend.quantities) {
    if (q.count(LeftOut::none) > fewest_learned) ++trend.watched;
  }
  for (QuantityTrend& q : trend.quantities) chart(q, baseline, times, trend.watched);
  return trend;
}

}  // namespace

std::size_t QuantityTrend::count(LeftOut why) const {
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [&](const HistoryPoint& p) { return p.left_out == why; }));
}

TrendState JointTrend::state() const {
  TrendState worst = TrendState::too_few;
  for (const QuantityTrend& q : quantities) worst = std::max(worst, q.state);
  return worst;
}

std::vector<JointTrend> joint_trends(const std::vector<calibration::Measured>& calibrations,
                                     const Baseline& baseline) {
  const BaselineTimes times = times_of(baseline);
  std::vector<JointTrend> trends;
  for (std::size_t begin = 0; begin < calibrations.size();) {
    std::size_t end = begin;
    const calibration::JointName& of = calibrations[begin].entry.facts.of;
    while (end < calibrations.size() && calibrations[end].entry.facts.of == of) ++end;
    const auto at = [&](std::size_t k) {
      return calibrations.begin() + static_cast<std::ptrdiff_t>(k);
    };
    trends.push_back(trend_of({at(begin), at(end)}, baseline, times));
    begin = end;
  }
  return trends;
}

namespace {

/// @param day from 1970-01-01 on. @return "2027-08-14"; empty beyond the year 2999.
std::string date_of_day(double day) {
  constexpr double last_day = 376'200;
  if (!(day < last_day)) return "";
  const std::chrono::year_month_day date{
      std::chrono::sys_days{std::chrono::days{static_cast<int>(std::floor(day))}}};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

}  // namespace

void state_limits(std::vector<JointTrend>& trends, double percent) {
  for (JointTrend& trend : trends) {
    for (QuantityTrend& q : trend.quantities) {
      for (FoundChange& c : q.changes) {
        if (!c.is_slow || !c.percent || !(c.drift_days > 0)) continue;
        constexpr double seconds = 86400;
        const double first = calibration::seconds_of_utc(c.from) / seconds;
        const double rate = std::abs(*c.percent) / c.drift_days;
        const double half_width = rate * std::abs(c.size.half_width() / c.size.value);
        const auto reached = [&](double at_rate) {
          return at_rate > 0 ? date_of_day(first + percent / at_rate) : "";
        };
        c.limit = {percent, reached(rate), reached(rate + half_width), reached(rate - half_width)};
      }
    }
  }
}

}  // namespace tribolog::history
