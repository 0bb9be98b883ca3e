#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include "base/input_file.h"
#include "ingest/text/csv_reader.h"
#include "inspect/survey/survey_parts.h"

namespace tribolog::inspect::survey {

namespace {

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

}  // namespace

std::vector<RowsOfJoint> rows_of_joints(const std::string& path, ingest::log::LogFormat format,
                                        const ingest::text::TextLogRules& rules,
                                        const ingest::log::LogTable& table) {
  const auto told_by = column_of_joints(table);
  if (!told_by) return {};
  const std::string key = survey_column(table.columns[*told_by], table.header).key;
  ingest::log::LogColumn joints;
  if (format == ingest::log::LogFormat::text) {  // as it is written there, "01" say
    InputFileSource bytes(path);
    ingest::text::CsvTable words =
        ingest::text::read_csv(bytes, path, {{key, "", ingest::log::ColumnReading::words}}, rules);
    if (words.rows != table.rows) return {};  // it is being written
    joints = std::move(words.columns.front());
  } else {
    joints = ingest::log::as_words(table.columns[*told_by]);
  }
  std::vector<RowsOfJoint> all;
  for (std::size_t word = 0; word < joints.words.size(); ++word) {
    RowsOfJoint one{table, key, joints.words[word]};
    one.table.columns.erase(one.table.columns.begin() + static_cast<std::ptrdiff_t>(*told_by));
    ingest::log::keep_rows_of(joints, word, one.table);
    if (word > 0) one.table.notes.clear();
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace tribolog::inspect::survey
