#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>

#include "base/input_file.h"
#include "ingest/text/csv_reader.h"
#include "inspect/survey/survey_parts.h"

namespace tribolog::inspect::survey {

namespace {

/// The rows at which another value begins than stood in the row before.
std::vector<std::size_t> begins_of_runs(const std::vector<double>& values) {
  std::vector<std::size_t> begins;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (row == 0 || values[row] != values[row - 1]) begins.push_back(row);
  }
  return begins;
}

/// Whether no column of times goes on where these rows begin.
bool has_clock_anew(const ingest::log::LogTable& table, const std::vector<std::size_t>& begins) {
  std::vector<ingest::log::ColumnHeader> header;
  for (const ingest::log::LogColumn& column : table.columns) header.push_back(column.header);
  for (const ingest::layout::ColumnMeaning& meaning :
       ingest::layout::guess_layout(header).columns) {
    if (meaning.quantity != ingest::log::Quantity::time) continue;
    const std::vector<double>& times = table.columns[meaning.column].values;
    for (std::size_t k = 1; k < begins.size(); ++k) {
      if (times[begins[k]] > times[begins[k] - 1]) return false;
    }
  }
  return true;
}

/// The column of words, or of numbers that are names, that tells whose row it is; nothing for a log
/// in which a row is all joints'.
std::optional<std::size_t> column_of_joints(const ingest::log::LogTable& table) {
  constexpr std::array whose = {"joint", "axis",   "motor", "servo",  "actuator",
                                "achse", "gelenk", "oś",    "przegub"};
  constexpr std::array besides = {"id", "name", "names", "no", "nr", "number", "index", "idx"};
  constexpr double fewest_changes = 0.5;
  constexpr std::size_t most_joints = 64;
  const auto is_in = [](const auto& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const ingest::log::LogColumn& column = table.columns[k];
    const auto words = ingest::layout::words_of_name(column.header.name);
    const bool is_named = !words.empty() &&
                          (is_in(whose, words.front()) || column.header.name == "name") &&
                          std::all_of(words.begin(), words.end(), [&](const std::string& word) {
                            return is_in(whose, word) || is_in(besides, word);
                          });
    const bool may_be = is_named && column.gaps == 0 &&
                        (column.reading == ingest::log::ColumnReading::number ||
                         column.reading == ingest::log::ColumnReading::words);
    if (!may_be) continue;
    std::map<double, std::size_t> rows_of;
    std::size_t changes = 0;
    for (std::size_t row = 0; row < column.values.size(); ++row) {
      if (row > 0 && column.values[row] != column.values[row - 1]) ++changes;
      if (rows_of.size() <= most_joints) ++rows_of[column.values[row]];
    }
    if (rows_of.size() < 2 || rows_of.size() > most_joints) continue;
    const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [fewest, most] = std::minmax_element(rows_of.begin(), rows_of.end(), fewer);
    const bool are_even = most->second <= 2 * fewest->second;
    const bool are_numbers_of_joints =
        std::all_of(rows_of.begin(), rows_of.end(), [](const auto& joint) {
          return joint.first >= 0 && joint.first == std::floor(joint.first);
        });
    const bool are_mixed =
        static_cast<double>(changes) > fewest_changes * static_cast<double>(table.rows);
    const bool are_behind_each_other = changes + 1 == rows_of.size();
    if (are_even && are_numbers_of_joints && (are_mixed || are_behind_each_other)) return k;
  }
  return std::nullopt;
}

/// The column that numbers recordings one behind the other, as LeRobot's "episode_index" does;
/// nothing where the log is one recording, or its clock goes on from one to the next.
std::optional<std::size_t> column_of_recordings(const ingest::log::LogTable& table) {
  constexpr std::array besides = {"episode", "id", "no", "nr", "number", "index", "idx"};
  const auto is_named = [&](const ingest::log::LogColumn& column) {
    const auto words = ingest::layout::words_of_name(column.header.name);
    return !words.empty() && words.front() == "episode" &&
           std::all_of(words.begin(), words.end(), [&](const std::string& word) {
             return std::find(besides.begin(), besides.end(), word) != besides.end();
           });
  };
  const auto column = std::find_if(table.columns.begin(), table.columns.end(), is_named);
  if (column == table.columns.end() || column->gaps > 0) return std::nullopt;
  const std::vector<std::size_t> begins = begins_of_runs(column->values);
  std::set<double> numbers;
  for (const std::size_t row : begins) numbers.insert(column->values[row]);
  const bool are_behind_each_other = numbers.size() == begins.size();
  if (begins.size() < 2 || !are_behind_each_other || !has_clock_anew(table, begins)) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(column - table.columns.begin());
}

/// What stands in a column, by the words of a text log as they are written there, "01" say.
/// @return nothing where the log is being written.
std::optional<ingest::log::LogColumn> words_of(const std::string& path,
                                               ingest::log::LogFormat format,
                                               const ingest::text::TextLogRules& rules,
                                               const ingest::log::LogTable& table,
                                               std::size_t column) {
  if (format != ingest::log::LogFormat::text) return ingest::log::as_words(table.columns[column]);
  const std::string key = survey_column(table.columns[column], table.header).key;
  InputFileSource bytes(path);
  ingest::text::CsvTable words =
      ingest::text::read_csv(bytes, path, {{key, "", ingest::log::ColumnReading::words}}, rules);
  if (words.rows != table.rows) return std::nullopt;
  return std::move(words.columns.front());
}

}  // namespace

std::vector<RowsOfOne> rows_of_each(const std::string& path, ingest::log::LogFormat format,
                                    const ingest::text::TextLogRules& rules,
                                    const ingest::log::LogTable& table) {
  const bool has_words = format == ingest::log::LogFormat::text ||
                         format == ingest::log::LogFormat::json ||
                         format == ingest::log::LogFormat::parquet;
  auto named_by = has_words ? column_of_joints(table) : std::nullopt;
  const bool are_joints = named_by.has_value();
  if (!named_by) named_by = column_of_recordings(table);
  if (!named_by) return {};
  const auto words = words_of(path, format, rules, table, *named_by);
  if (!words) return {};
  const std::string key = survey_column(table.columns[*named_by], table.header).key;
  std::vector<std::vector<std::size_t>> rows(words->words.size());
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (!std::isnan(words->values[row])) {
      rows[static_cast<std::size_t>(words->values[row])].push_back(row);
    }
  }
  std::vector<RowsOfOne> all;
  for (std::size_t word = 0; word < rows.size(); ++word) {
    RowsOfOne one{ingest::log::with_rows(table, rows[word]), key, words->words[word], !are_joints};
    one.table.columns.erase(one.table.columns.begin() + static_cast<std::ptrdiff_t>(*named_by));
    if (word > 0) one.table.notes.clear();
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace tribolog::inspect::survey
