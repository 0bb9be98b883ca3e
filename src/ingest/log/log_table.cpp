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

void keep_rows_of(const LogColumn& told_by, std::size_t word, LogTable& table) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (told_by.values[row] == static_cast<double>(word)) rows.push_back(row);
  }
  for (LogColumn& column : table.columns) {
    std::vector<double> values(rows.size());
    std::transform(rows.begin(), rows.end(), values.begin(),
                   [&](std::size_t row) { return column.values[row]; });
    column.gaps = static_cast<std::size_t>(std::count_if(
        values.begin(), values.end(), [](double value) { return std::isnan(value); }));
    column.values = std::move(values);
  }
  std::vector<std::pair<std::size_t, long>> breaks;
  long expected = -1;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const long line = table.line_of(rows[k]);
    if (line != expected) breaks.emplace_back(k, line);
    expected = line + 1;
  }
  if (!table.line_breaks.empty()) table.line_breaks = std::move(breaks);
  table.other_rows += table.rows - rows.size();
  table.rows = rows.size();
}

}  // namespace tribolog::ingest::log
