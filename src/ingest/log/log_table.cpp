#include "ingest/log/log_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

namespace tribolog::ingest::log {

long LogTable::line_of(std::size_t row) const {
  const auto after =
      std::upper_bound(line_breaks.begin(), line_breaks.end(), row,
                       [](std::size_t wanted, const auto& entry) { return wanted < entry.first; });
  if (after == line_breaks.begin()) return 0;
  const auto& [first_row, first_line] = *std::prev(after);
  return first_line + static_cast<long>(row - first_row);
}

LogColumn as_words(LogColumn column) {
  if (column.reading == ColumnReading::words) return column;
  std::map<double, std::size_t> places;
  for (double& value : column.values) {
    if (std::isnan(value)) continue;
    const auto [place, is_new] = places.emplace(value, column.words.size());
    if (is_new) column.words.push_back(fmt::format("{}", value));
    value = static_cast<double>(place->second);
  }
  column.reading = ColumnReading::words;
  return column;
}

LogColumn with_rows(const LogColumn& column, const std::vector<std::size_t>& rows) {
  LogColumn kept{column.header, {}, column.origin, 0, column.reading, column.words};
  kept.stands_in = column.stands_in;
  kept.values.resize(rows.size());
  std::transform(rows.begin(), rows.end(), kept.values.begin(),
                 [&](std::size_t row) { return column.values[row]; });
  kept.gaps = static_cast<std::size_t>(std::count_if(
      kept.values.begin(), kept.values.end(), [](double value) { return std::isnan(value); }));
  return kept;
}

namespace {

/// Of these rows; none of a table without lines.
std::vector<std::pair<std::size_t, long>> line_breaks_of(const LogTable& table,
                                                         const std::vector<std::size_t>& rows) {
  std::vector<std::pair<std::size_t, long>> breaks;
  if (table.line_breaks.empty()) return breaks;
  long expected = -1;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const long line = table.line_of(rows[k]);
    if (line != expected) breaks.emplace_back(k, line);
    expected = line + 1;
  }
  return breaks;
}

}  // namespace

LogTable with_rows(const LogTable& table, const std::vector<std::size_t>& rows) {
  LogTable kept;
  kept.file = table.file;
  kept.group = table.group;
  kept.header = table.header;
  for (const LogColumn& column : table.columns) kept.columns.push_back(with_rows(column, rows));
  kept.rows = rows.size();
  kept.cut_rows = table.cut_rows;
  kept.bad_rows = table.bad_rows;
  kept.unclear_rows = table.unclear_rows;
  kept.other_rows = table.other_rows + (table.rows - rows.size());
  kept.rows_of_others = table.rows_of_others;
  kept.notes = table.notes;
  kept.refusal = table.refusal;
  kept.line_breaks = line_breaks_of(table, rows);
  return kept;
}

std::vector<std::size_t> rows_that_say(const LogColumn& column, std::size_t word) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < column.values.size(); ++row) {
    if (column.values[row] == static_cast<double>(word)) rows.push_back(row);
  }
  return rows;
}

void keep_rows_of(const LogColumn& named_by, std::size_t word, LogTable& table) {
  table = with_rows(table, rows_that_say(named_by, word));
}

}  // namespace tribolog::ingest::log
