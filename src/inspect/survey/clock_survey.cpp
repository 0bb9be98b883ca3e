#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/requirements.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/log/row_clock.h"
#include "ingest/log/units.h"
#include "inspect/survey/log_survey.h"

namespace tribolog::inspect::survey {
namespace {

constexpr double gap_intervals = 5;
// Robots are logged between these rates; the first unit that gives one of them is taken.
constexpr double slowest_Hz = 5;
constexpr double fastest_Hz = 20'000;
constexpr std::array units = {"s", "ms", "us", "ns"};
constexpr std::array rare_units = {"min", "h", "day"};  // of spreadsheets

std::string unit_by_magnitude(double interval) {
  const auto is_likely = [&](const char* unit) {
    const double seconds =
        interval * present(ingest::log::find_si_factor(ingest::log::Quantity::time, unit));
    return seconds > 0 && 1 / seconds >= slowest_Hz && 1 / seconds <= fastest_Hz;
  };
  const auto usual = std::find_if(units.begin(), units.end(), is_likely);
  if (usual != units.end()) return *usual;
  const auto rare = std::find_if(rare_units.begin(), rare_units.end(), is_likely);
  return rare != rare_units.end() ? *rare : "s";
}

/// Of a reading that counts from 1970, from 1601 as Windows does or from the year 1 as .NET does:
/// the unit with which it is of these decades. Nothing for any other.
std::optional<std::string> unit_by_origin(double origin) {
  constexpr double year_s = 365.25 * 86'400;
  constexpr double from_s = 25 * year_s;  // 1995
  constexpr double to_s = 130 * year_s;   // 2100
  const auto is_of_now = [&](double unit_s, double since_1970_s) {
    const double s = std::abs(origin) * unit_s - since_1970_s;
    return s > from_s && s < to_s;
  };
  for (const char* unit : units) {
    const double unit_s = present(ingest::log::find_si_factor(ingest::log::Quantity::time, unit));
    if (is_of_now(unit_s, 0)) return unit;
  }
  constexpr double hundred_ns = 1e-7;
  constexpr double from_1601_s = 11'644'473'600;
  constexpr double from_1_s = 62'135'596'800;
  if (is_of_now(hundred_ns, from_1601_s) || is_of_now(hundred_ns, from_1_s)) return "100 ns";
  return std::nullopt;
}

}  // namespace

bool ClockSurvey::has_odd_rate() const {
  return rate_Hz() > 0 && (rate_Hz() < ingest::dataset::slowest_rate_Hz ||
                           rate_Hz() > ingest::dataset::fastest_rate_Hz);
}

ClockSurvey survey_clock(const ingest::log::LogColumn& column,
                         const ingest::layout::ColumnMeaning& meaning) {
  ClockSurvey clock;
  const std::string text_unit(ingest::log::unit_of_time(column.reading));
  clock.column = clock.key = column.header.full;
  clock.origin = column.origin;
  std::vector<double> values;
  for (const double value : column.values) {
    if (std::isfinite(value)) values.push_back(value);
  }
  clock.missing = column.values.size() - values.size();
  const double interval = ingest::log::median_clock_step(values);
  const bool is_text = !text_unit.empty();
  const auto by_origin = unit_by_origin(column.origin);
  clock.unit_is_stated = is_text || meaning.unit_is_stated;
  clock.unit = is_text                  ? text_unit
               : meaning.unit_is_stated ? meaning.unit
               : by_origin              ? *by_origin
                                        : unit_by_magnitude(interval);
  clock.is_proven = !clock.unit_is_stated && by_origin;
  if (clock.is_proven) clock.unit_by = "its readings are dates of these decades";
  if (!is_text)
    clock.seconds_per_unit =
        present(ingest::log::find_si_factor(ingest::log::Quantity::time, clock.unit));
  clock.interval_s = interval * clock.seconds_per_unit;
  if (values.empty()) return clock;
  clock.first_s = *std::min_element(values.begin(), values.end()) * clock.seconds_per_unit;
  clock.last_s = *std::max_element(values.begin(), values.end()) * clock.seconds_per_unit;
  double squares = 0;
  std::size_t regular = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step_s = (values[i] - values[i - 1]) * clock.seconds_per_unit;
    if (step_s == 0) {
      ++clock.repeated;
    } else if (step_s < 0) {
      ++clock.back;
      clock.largest_step_back_s = std::max(clock.largest_step_back_s, -step_s);
    } else if (step_s > gap_intervals * clock.interval_s) {
      clock.gaps.push_back({values[i - 1] * clock.seconds_per_unit, step_s});
    } else {
      squares += std::pow(step_s / clock.interval_s - 1, 2);
      ++regular;
    }
  }
  if (regular > 0) clock.jitter_percent = 100 * std::sqrt(squares / static_cast<double>(regular));
  return clock;
}

}  // namespace tribolog::inspect::survey
