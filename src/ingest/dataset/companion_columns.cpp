#include "ingest/dataset/companion_columns.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "base/requirements.h"
#include "ingest/dataset/recording_rows.h"
#include "ingest/log/row_clock.h"

namespace tribolog::ingest::dataset {

namespace {

constexpr double largest_time_difference = 0.5;  // of a step: beyond, another row is nearer

bool is_beside(const manifest::RecordingEntry& entry, const manifest::ColumnEntry& column) {
  return !column.file.empty() && column.file != entry.file;
}

template <class Condition>
void keep_if(manifest::ColumnEntries& columns, const Condition& condition) {
  for (auto* column : {&columns.time, &columns.angle, &columns.speed, &columns.effort,
                       &columns.bristle, &columns.bristle_rate, &columns.temperature}) {
    if (*column && !condition(**column)) column->reset();
  }
}

/// Stated, or of the same name as the recording's. A position names no column of another file.
std::optional<log::WantedColumn> time_to_compare(const manifest::ColumnEntry& time,
                                                 const manifest::ColumnEntries& columns) {
  std::string stated;
  for (const LoggedColumn& column : logged_columns(columns)) {
    const manifest::ColumnEntry& entry = *column.entry;
    if (entry.time_in_file.empty()) continue;
    if (!stated.empty() && entry.time_in_file != stated) {
      throw InputError(entry.where,
                       {"another name for the time of " + in_quotes(entry.file),
                        in_quotes(entry.time_in_file), in_quotes(stated), "state it once"});
    }
    stated = entry.time_in_file;
  }
  if (!stated.empty()) return log::WantedColumn{stated, "", time.reading};
  if (time.name.starts_with('#') || time.rate_Hz || time.plus) return std::nullopt;
  return log::WantedColumn{time.name, "", time.reading, true};
}

void refuse_left_out_rows(const log::LogTable& table) {
  const std::size_t left_out = table.bad_rows + table.unclear_rows + table.remark_rows;
  if (left_out == 0) return;
  throw InputError({table.file, 0, 0},
                   {std::string("the rows of several files are matched one by one, and rows are "
                                "left out here") +
                        (table.bad_rows > 0 ? " (skip_bad_rows)" : ""),
                    fmt::format("{}", left_out), "none", "mend them, or write nan"});
}

void refuse_other_number_of_rows(const manifest::RecordingEntry& entry, const log::LogTable& own,
                                 const log::LogTable& other) {
  const std::size_t rows = own.rows + own.cut_rows;
  const std::size_t found = other.rows + other.cut_rows;
  if (found == rows) return;
  throw InputError({other.file, 0, 0},
                   {"the number of rows is not that of " + in_quotes(entry.file),
                    fmt::format("{}", found), fmt::format("{}", rows),
                    "the rows of both files are matched one by one: log both at the same moments, "
                    "or bring them to one clock in one file"});
}

/// A time that is a gap in either file says nothing.
void refuse_other_times(const manifest::RecordingEntry& entry, const log::LogColumn& own,
                        const log::LogTable& table) {
  const log::LogColumn& other = table.columns.back();
  const double allowed = largest_time_difference * log::median_clock_step(own.values);
  const double later = other.origin - own.origin;
  const manifest::ColumnEntry& time = present(entry.columns.time);
  const bool is_number = log::unit_of_time(time.reading).empty();
  const std::string unit = is_number ? printable(time.unit) : "s";
  for (std::size_t row = 0; row < table.rows; ++row) {
    const double found = other.values[row] + later;
    if (!(std::abs(found - own.values[row]) > allowed)) continue;
    throw InputError(
        {table.file, table.line_of(row), 0},
        {fmt::format("column {}: row {} is of another time than in {}",
                     in_quotes(other.header.full), row + 1, in_quotes(entry.file)),
         fmt::format("{:.9g} {}", found, unit),
         fmt::format("{:.9g} {} within half a sampling step, {:.3g} {}", own.values[row], unit,
                     allowed, unit),
         "the rows of both files are matched one by one: log both at the same moments, or bring "
         "them to one clock in one file"});
  }
}

std::shared_ptr<const log::LogTable> lines_of(const log::LogTable& table) {
  log::LogTable lines;
  lines.file = table.file;
  lines.line_breaks = table.line_breaks;
  return std::make_shared<const log::LogTable>(std::move(lines));
}

void shorten(log::LogTable& table, std::size_t rows) {
  for (log::LogColumn& column : table.columns) {
    for (std::size_t row = rows; row < table.rows; ++row) {
      column.gaps -= std::isnan(column.values[row]) ? 1 : 0;
    }
    column.values.resize(rows);
  }
  table.cut_rows += table.rows - rows;
  table.rows = rows;
}

/// All rows that every file has, where the last ones of some are cut off.
void match_rows(const manifest::RecordingEntry& entry,
                const std::vector<manifest::RecordingEntry>& entries,
                std::vector<log::LogTable>& companions, log::LogTable& table) {
  refuse_left_out_rows(table);
  std::size_t rows = table.rows;
  for (const log::LogTable& companion : companions) {
    refuse_left_out_rows(companion);
    refuse_other_number_of_rows(entry, table, companion);
    rows = std::min(rows, companion.rows);
  }
  shorten(table, rows);
  for (std::size_t k = 0; k < companions.size(); ++k) {
    shorten(companions[k], rows);
    const bool has_time = companions[k].columns.size() > logged_columns(entries[k].columns).size();
    if (has_time) refuse_other_times(entry, table.columns.front(), companions[k]);
  }
}

}  // namespace

manifest::RecordingEntry without_companions(const manifest::RecordingEntry& entry) {
  manifest::RecordingEntry own = entry;
  keep_if(own.columns,
          [&](const manifest::ColumnEntry& column) { return !is_beside(entry, column); });
  return own;
}

std::vector<manifest::RecordingEntry> companions_of(const manifest::RecordingEntry& entry) {
  std::vector<manifest::RecordingEntry> companions;
  for (const LoggedColumn& column : logged_columns(entry.columns)) {
    const std::string& file = column.entry->file;
    const bool is_known = std::any_of(
        companions.begin(), companions.end(),
        [&](const manifest::RecordingEntry& companion) { return companion.file == file; });
    if (!is_beside(entry, *column.entry) || is_known) continue;
    manifest::RecordingEntry companion;
    companion.role = entry.role;
    companion.file = companion.name = file;
    companion.where = column.entry->where;
    companion.columns = entry.columns;
    keep_if(companion.columns,
            [&](const manifest::ColumnEntry& other) { return other.file == file; });
    if (entry.columns.rows) {
      throw InputError(column.entry->where,
                       {"stands in another file", in_quotes(file),
                        "all columns in one, where rows are those of one joint", ""});
    }
    companion.time_to_compare = time_to_compare(present(entry.columns.time), companion.columns);
    companions.push_back(std::move(companion));
  }
  return companions;
}

void join_companions(const manifest::RecordingEntry& entry, std::vector<log::LogTable> companions,
                     log::LogTable& table) {
  if (companions.empty()) return;
  const std::vector<manifest::RecordingEntry> entries = companions_of(entry);
  match_rows(entry, entries, companions, table);
  for (log::LogTable& companion : companions) {
    const auto lines = lines_of(companion);
    for (log::LogColumn& column : companion.columns) column.stands_in = lines;
  }
  std::vector<log::LogColumn> joined;
  std::vector<std::size_t> next(companions.size());
  std::size_t next_own = 0;
  for (const LoggedColumn& column : logged_columns(entry.columns)) {
    if (!is_beside(entry, *column.entry)) {
      joined.push_back(std::move(table.columns[next_own++]));
      continue;
    }
    const auto at = std::find_if(
        entries.begin(), entries.end(),
        [&](const manifest::RecordingEntry& e) { return e.file == column.entry->file; });
    const auto k = static_cast<std::size_t>(at - entries.begin());
    joined.push_back(std::move(companions[k].columns[next[k]++]));
  }
  std::move(table.columns.begin() + static_cast<std::ptrdiff_t>(next_own), table.columns.end(),
            std::back_inserter(joined));
  table.columns = std::move(joined);
}

}  // namespace tribolog::ingest::dataset
