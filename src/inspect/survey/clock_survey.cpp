#include <algorithm>
#include <array>
#include <cmath>

#include "base/requirements.h"
#include "ingest/dataset/companion_columns.h"
#include "ingest/log/units.h"
#include "inspect/survey/log_survey.h"

namespace tribolog::inspect::survey {
namespace {

constexpr double gap_intervals = 5;
// Robots are logged between these rates; the first unit that gives one of them is taken.
constexpr double slowest_Hz = 2;
constexpr double fastest_Hz = 20'000;
constexpr std::array units = {"s", "ms", "us", "ns"};

std::string unit_by_magnitude(double interval) {
  for (const char* unit : units) {
    const double seconds =
        interval * present(ingest::log::find_si_factor(ingest::log::Quantity::time, unit));
    if (seconds > 0 && 1 / seconds >= slowest_Hz && 1 / seconds <= fastest_Hz) return unit;
  }
  return "s";
}

}  // namespace

ClockSurvey survey_clock(const ingest::log::LogColumn& column,
                         const ingest::layout::ColumnMeaning& meaning, bool is_iso) {
  ClockSurvey clock;
  clock.column = column.header.full;
  clock.origin = column.origin;
  std::vector<double> values;
  for (const double value : column.values) {
    if (std::isfinite(value)) values.push_back(value);
  }
  clock.missing = column.values.size() - values.size();
  const double interval = ingest::dataset::median_clock_step(values);
  clock.unit_is_stated = is_iso || meaning.unit_is_stated;
  clock.unit = is_iso                   ? "iso8601"
               : meaning.unit_is_stated ? meaning.unit
                                        : unit_by_magnitude(interval);
  if (!is_iso)
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
