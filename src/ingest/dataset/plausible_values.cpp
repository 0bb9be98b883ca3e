#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/requirements.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/log/units.h"
#include "ingest/text/csv_dialect.h"

namespace tribolog::ingest::dataset {
namespace {

constexpr double likely_largest_angle_rad = 7.0;  // a little more than a turn
constexpr double likely_largest_torque_Nm = 1e5;  // the largest robots hold 1 t at 3 m: 3e4 N·m
constexpr double slowest_likely_Hz = 10.0;
constexpr double fastest_likely_Hz = 1e4;
// Ten samples on each reversal of an oscillation of 0.3 Hz, the slowest that is usual.
constexpr double slowest_for_loops_Hz = 30.0;

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

double median_rate_Hz(const std::vector<double>& t_s) {
  constexpr std::size_t sampled = 10'000;
  const std::size_t stride = t_s.size() / sampled + 1;
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < t_s.size(); i += stride) steps_s.push_back(t_s[i] - t_s[i - 1]);
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  return 1 / *middle;
}

/// "in ms they would be 100"
std::string likelier_units(const manifest::ColumnEntry& time, double rate_Hz) {
  std::string text;
  for (const char* const unit : {"s", "ms", "us", "ns"}) {
    const double factor = log::si_factor(log::Quantity::time, unit, time.where);
    const double rate = rate_Hz * time.si_factor / factor;
    if (rate < slowest_likely_Hz || rate > fastest_likely_Hz) continue;
    text += fmt::format("{}in {} they would be {:.3g}", text.empty() ? "" : ", ", unit, rate);
  }
  return text;
}

[[noreturn]] void refuse_rate(const manifest::ColumnEntry& time, const log::LogTable& table,
                              double rate_Hz) {
  const bool is_iso = time.reading == log::ColumnReading::iso_time;
  const std::string likelier = is_iso ? "" : likelier_units(time, rate_Hz);
  throw InputError(
      {table.file, 0, 0},
      {fmt::format("column {}: {:.3g} samples per second, read in {}",
                   in_quotes(table.columns.front().header.full), rate_Hz, printable(time.unit)),
       "", fmt::format("{} to {}", slowest_rate_Hz, fastest_rate_Hz),
       fmt::format("{}{}if this is right, state any_rate = true beside the unit",
                   is_iso ? "" : "another unit of time? ",
                   likelier.empty() ? "" : likelier + "; ")});
}

void judge_rate(const manifest::RecordingEntry& entry, const log::LogTable& table,
                const joint::Recording& r, RecordingNotes& notes) {
  const manifest::ColumnEntry& time = present(entry.columns.time);
  if (time.any_rate) return;
  const double rate_Hz = median_rate_Hz(r.t_s);
  if (!(rate_Hz >= slowest_rate_Hz && rate_Hz <= fastest_rate_Hz)) {
    refuse_rate(time, table, rate_Hz);
  }
  const bool has_loops = r.role == joint::Role::oscillation || r.role == joint::Role::break_away;
  if (rate_Hz < slowest_likely_Hz) {
    notes.add({"reading.unlikely_rate", {{"rate_Hz", rate_Hz}, {"unit", printable(time.unit)}}});
  } else if (has_loops && rate_Hz < slowest_for_loops_Hz && !notes.has("reading.slow_for_loops")) {
    notes.add({"reading.slow_for_loops", {{"rate_Hz", rate_Hz}}});
  }
}

}  // namespace

double largest_possible(log::Quantity quantity) {
  switch (quantity) {
    case log::Quantity::time:
      break;
    case log::Quantity::angle:
    case log::Quantity::angular_speed:
      return 1e6;  // rad, rad/s: a motor's hundred thousand turns
    case log::Quantity::torque:
      return 1e7;  // N·m
    case log::Quantity::current:
      return 1e5;  // A
    case log::Quantity::temperature:
      return 1e4;  // °C
  }
  return std::numeric_limits<double>::infinity();
}

double largest_possible(const manifest::ColumnEntry& column) {
  return largest_possible(column.quantity) / std::abs(column.si_factor);
}

void refuse_impossible_value(const manifest::ColumnEntry& column, double value,
                             const log::LogTable& table, std::size_t row) {
  throw InputError(
      {table.file, table.line_of(row), 0},
      {fmt::format("column {}: no joint has {} of this size", in_quotes(column.name),
                   log::to_string(column.quantity)),
       fmt::format("{:.6g} {}", value, printable(column.unit)),
       fmt::format("at most {:.6g} {}", largest_possible(column), printable(column.unit)),
       "another unit? where only this row is damaged, write nan, or [log] skip_bad_rows = "
       "true leaves it out, up to 1 % of all"});
}

std::vector<std::size_t> rows_beyond(const std::vector<double>& values, double bound) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (std::abs(values[row]) > bound) rows.push_back(row);
  }
  return rows;
}

std::optional<log::LogTable> without_impossible_values(const manifest::RecordingEntry& entry,
                                                       const log::LogTable& table) {
  std::optional<log::LogTable> out;
  const std::vector<LoggedColumn> columns = logged_columns(entry.columns);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const manifest::ColumnEntry& column = *columns[k].entry;
    std::vector<std::size_t> rows = rows_beyond(table.columns[k].values, largest_possible(column));
    if (rows.empty()) continue;
    if (static_cast<double>(rows.size()) >
        text::most_bad_rows * static_cast<double>(table.columns[k].values.size())) {
      refuse_impossible_value(column, table.columns[k].values[rows.front()],
                              table.columns[k].stands_in ? *table.columns[k].stands_in : table,
                              rows.front());
    }
    if (!out) out = table;
    for (const std::size_t row : rows) out->columns[k].values[row] = NAN;
    out->columns[k].impossible = std::move(rows);
  }
  return out;
}

void judge_units(const manifest::RecordingEntry& entry, const log::LogTable& table,
                 const joint::Drive& drive, const joint::Recording& recording,
                 RecordingNotes& notes) {
  const double angle_rad = largest(recording.q_rad);
  if (angle_rad > likely_largest_angle_rad && !notes.has("reading.large_angle")) {
    notes.add({"reading.large_angle",
               {{"angle_rad", angle_rad}, {"unit", printable(present(entry.columns.angle).unit)}}});
  }
  const double torque_Nm = largest(recording.torque_Nm) * drive.gear_ratio();
  if (torque_Nm > likely_largest_torque_Nm) {
    notes.add(
        {"reading.large_torque",
         {{"torque_Nm", torque_Nm}, {"unit", printable(present(entry.columns.effort).unit)}}});
  }
  judge_rate(entry, table, recording, notes);
}

}  // namespace tribolog::ingest::dataset
