#include "ingest/dataset/long_text_log.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/input_file.h"
#include "base/statement.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/long_format.h"
#include "ingest/dataset/log_reader.h"
#include "ingest/text/csv_reader.h"

namespace tribolog::ingest::dataset {
namespace {

/// Nothing where a column holds what no array does, as a time of day.
std::optional<arrays::FileArrays> arrays_of(text::CsvTable table) {
  arrays::FileArrays found;
  for (log::LogColumn& column : table.columns) {
    arrays::NamedArray& array = found.arrays.emplace_back();
    array.name = column.header.full;
    array.rows = column.values.size();
    array.values = std::move(column.values);
    array.origin = column.origin;
    array.words = std::move(column.words);
    array.is_time = column.reading == log::ColumnReading::iso_time;
    const bool is_held = array.is_time || column.reading == log::ColumnReading::number ||
                         column.reading == log::ColumnReading::words;
    if (!is_held) return std::nullopt;
  }
  return found;
}

/// Spread, with what the user should know; nothing where it is in another format.
std::optional<std::pair<arrays::FileArrays, std::vector<Statement>>> spread(text::CsvTable table) {
  auto found = arrays_of(std::move(table));
  if (!found) return std::nullopt;
  std::vector<Statement> notes = arrays::spread_signals(*found);
  if (notes.empty()) return std::nullopt;
  return std::pair{std::move(*found), std::move(notes)};
}

bool has_all(const text::CsvTable& table, const std::vector<log::WantedColumn>& wanted) {
  const auto is_there = [&](const log::WantedColumn& one) {
    if (one.is_optional || one.name.starts_with('#')) return true;
    return std::any_of(table.columns.begin(), table.columns.end(), [&](const auto& column) {
      return column.header.full == one.name || column.header.name == one.name;
    });
  };
  return !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), is_there);
}

bool shows_long_format(const text::CsvTable& first_rows,
                       const std::vector<log::WantedColumn>& wanted) {
  try {
    return !has_all(first_rows, wanted) && spread(first_rows).has_value();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::optional<text::CsvTable> first_rows_of_text(const std::string& path,
                                                 const text::TextLogRules& rules) {
  constexpr std::size_t enough_bytes = std::size_t{1} << 16;
  try {
    std::string start = read_start(path, enough_bytes);
    // Whole rows; none: no such log.
    if (start.size() == enough_bytes) start.resize(start.find_last_of("\r\n") + 1);
    return text::read_csv(std::string_view(start), path, {}, rules);
  } catch (const InputError&) {
    return std::nullopt;  // reported of the whole log, where the columns that are stated are read
  }
}

std::optional<std::vector<log::LogTable>> read_long_text(
    const std::string& path, const std::optional<text::CsvTable>& first_rows,
    const std::vector<log::WantedColumn>& wanted, const text::TextLogRules& rules) {
  if (!first_rows || !shows_long_format(*first_rows, wanted)) return std::nullopt;
  InputFileSource bytes(path);
  text::CsvTable table = text::read_csv(bytes, path, {}, rules);
  std::vector<Statement> notes = std::move(table.notes);
  const std::size_t cut = table.cut_rows;
  const std::size_t bad = table.bad_rows;
  auto found = spread(std::move(table));
  if (!found) return std::nullopt;
  std::vector<log::LogTable> tables = arrays::tables_of(std::move(found->first), path);
  log::LogTable& first = tables.front();
  first.cut_rows = cut;
  first.bad_rows = bad;
  first.notes.insert(first.notes.begin(), found->second.begin(), found->second.end());
  first.notes.insert(first.notes.begin(), notes.begin(), notes.end());
  return tables;
}

}  // namespace tribolog::ingest::dataset
