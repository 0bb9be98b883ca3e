#include "ingest/arrays/array_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/text/csv_dialect.h"
#include "wording/words.h"

namespace tribolog::ingest::arrays {
namespace {

constexpr std::size_t widest_guessed_matrix = 64;
constexpr std::size_t most_listed = 12;

bool is_scalar(const NamedArray& array) { return array.rows * array.columns == 1; }
bool is_matrix(const NamedArray& array) { return array.columns > 1; }

void transpose(NamedArray& matrix) {
  std::swap(matrix.rows, matrix.columns);
  matrix.by_columns = !matrix.by_columns;
}

/// Turns a matrix so that its rows are the samples. @return a note, where that is a guess.
Statement turn_rows_first(NamedArray& matrix, const std::set<std::size_t>& vector_lengths) {
  if (matrix.rows == matrix.columns) {
    return {
        "reading.square_matrix",
        {{"array", in_quotes(matrix.name)}, {"rows", matrix.rows}, {"columns", matrix.columns}}};
  }
  const std::size_t shorter = std::min(matrix.rows, matrix.columns);
  const std::size_t longer = std::max(matrix.rows, matrix.columns);
  const bool along_shorter = longer <= widest_guessed_matrix && !vector_lengths.contains(longer) &&
                             vector_lengths.contains(shorter);
  if (matrix.rows != (along_shorter ? shorter : longer)) transpose(matrix);
  return {};
}

double value_at(const NamedArray& array, std::size_t row, std::size_t column) {
  return array.values[array.by_columns ? column * array.rows + row : row * array.columns + column];
}

log::LogColumn column_of(const NamedArray& array, std::size_t column, const std::string& name) {
  log::LogColumn result{text::read_header_field(name), {}, 0};
  if (!array.unit.empty() && result.header.unit.empty()) result.header.unit = array.unit;
  if (array.is_time) result.reading = log::ColumnReading::iso_time;
  if (!array.words.empty()) result.reading = log::ColumnReading::words;
  result.words = array.words;
  result.origin = array.origin;
  result.values.resize(array.rows);
  for (std::size_t row = 0; row < array.rows; ++row) {
    const double value = value_at(array, row, column);
    const bool is_gap = !std::isfinite(value);
    result.values[row] = is_gap ? std::numeric_limits<double>::quiet_NaN() : value;
    result.gaps += is_gap ? 1 : 0;
  }
  return result;
}

std::string free_name(const std::string& wanted, const std::set<std::string>& taken) {
  for (std::size_t number = 2;; ++number) {
    std::string name = fmt::format("{}_{}", wanted, number);
    if (!taken.contains(name)) return name;
  }
}

void add_columns(NamedArray array, log::LogTable& table, std::set<std::string>& taken) {
  for (std::size_t i = 0; i < array.columns; ++i) {
    const std::string wanted = is_matrix(array) ? fmt::format("{}_{}", array.name, i) : array.name;
    const std::string name = taken.contains(wanted) ? free_name(wanted, taken) : wanted;
    if (name != wanted) {
      table.notes.push_back({"reading.column_renamed",
                             {{"column", in_quotes(wanted)},
                              {"array", in_quotes(array.name)},
                              {"name", in_quotes(name)}}});
    }
    taken.insert(name);
    table.header.push_back(name);
    table.columns.push_back(column_of(array, i, name));
  }
  if (array.was_rounded) {
    table.notes.push_back({"reading.integers_rounded", {{"array", in_quotes(array.name)}}});
  }
}

/// "run" of "run.q" and "run/q"; empty for a name without a group.
std::string group_of(const std::string& name) {
  const std::size_t end = name.find_last_of("/.");
  return end == std::string::npos ? "" : name.substr(0, end);
}

std::string common_group(const std::vector<NamedArray>& arrays) {
  const std::string group = group_of(arrays.front().name);
  const bool is_shared = std::all_of(arrays.begin(), arrays.end(), [&](const NamedArray& array) {
    return group_of(array.name) == group;
  });
  return is_shared ? group : "";
}

void name_groups(std::vector<log::LogTable>& tables, const std::vector<std::string>& first_names) {
  std::map<std::string, int> uses;
  for (const log::LogTable& table : tables) ++uses[table.group];
  for (std::size_t i = 0; i < tables.size(); ++i) {
    std::string& group = tables[i].group;
    if (group.empty() || uses[group] > 1) group = first_names[i];
  }
}

/// Scalars, texts and what was left out, each list cut with a count of the rest.
std::vector<Statement> notes_of(const FileArrays& found) {
  std::vector<Statement> facts;
  for (const NamedArray& array : found.arrays) {
    if (!is_scalar(array) || !array.words.empty()) continue;
    facts.push_back(
        {"reading.value",
         {{"name", printable(array.name)}, {"value", fmt::format("{}", array.values.front())}}});
  }
  for (const auto& [name, text] : found.texts) {
    facts.push_back({"reading.value", {{"name", printable(name)}, {"value", in_quotes(text)}}});
  }
  std::vector<Statement> notes;
  const auto add = [&](const std::vector<Statement>& list, Code more, const char* of_what) {
    const std::size_t listed = std::min(list.size(), most_listed);
    notes.insert(notes.end(), list.begin(), list.begin() + static_cast<std::ptrdiff_t>(listed));
    if (list.size() > listed) notes.push_back({more, {{of_what, list.size() - listed}}});
  };
  add(facts, "reading.more_values", "values");
  std::vector<Statement> refusals;
  for (const auto& [name, reason] : found.left_out) {
    refusals.push_back({"reading.not_read", {{"name", in_quotes(name)}, {"why", reason}}});
  }
  add(refusals, "reading.more_not_read", "arrays");
  return notes;
}

[[noreturn]] void refuse_without_rows(const std::vector<Statement>& notes,
                                      const std::string& file) {
  Statement held;
  for (const Statement& note : notes) held.add(note);
  throw InputError({file, 0, 0},
                   {"no rows of numbers", held.empty() ? "nothing" : wording::words(held),
                    "arrays of two or more numbers", ""});
}

/// Words without numbers beside them are no log.
void leave_out_lone_words(FileArrays& found) {
  std::set<std::size_t> lengths_of_numbers;
  for (const NamedArray& array : found.arrays) {
    if (array.words.empty()) lengths_of_numbers.insert({array.rows, array.columns});
  }
  std::erase_if(found.arrays, [&](const NamedArray& array) {
    const bool is_alone = !array.words.empty() && !lengths_of_numbers.contains(array.rows);
    if (is_alone) found.leave_out(array.name, "it holds texts");
    return is_alone;
  });
}

constexpr std::string_view simulink_values = ".signals.values";
constexpr std::string_view simulink_time = ".time";

const NamedArray* array_of(const FileArrays& found, const std::string& name) {
  const auto it = std::find_if(found.arrays.begin(), found.arrays.end(),
                               [&](const NamedArray& array) { return array.name == name; });
  return it == found.arrays.end() ? nullptr : &*it;
}

/// Simulink's structures with time, q.time and q.signals.values: the signal is q or, where it has
/// one, its label; their common clock is "time".
void name_as_simulink_means(FileArrays& found) {
  std::vector<std::string> signals;
  for (const NamedArray& array : found.arrays) {
    if (!array.name.ends_with(simulink_values)) continue;
    const std::string name(array.name, 0, array.name.size() - simulink_values.size());
    if (array_of(found, name + std::string(simulink_time)) != nullptr) signals.push_back(name);
  }
  if (signals.empty()) return;
  const NamedArray clock = *array_of(found, signals.front() + std::string(simulink_time));
  for (const std::string& name : signals) {
    const std::string of_clock = name + std::string(simulink_time);
    if (array_of(found, of_clock)->values != clock.values) continue;  // one of another clock
    std::string shown = name;
    const bool is_vector = array_of(found, name + std::string(simulink_values))->columns == 1;
    for (const auto& [key, text] : found.texts) {
      const bool is_one = is_vector && !text.empty() && array_of(found, text) == nullptr;
      if (key == name + ".signals.label" && is_one) shown = text;
    }
    for (NamedArray& array : found.arrays) {
      if (array.name == name + std::string(simulink_values)) array.name = shown;
    }
    std::erase_if(found.arrays, [&](const NamedArray& array) { return array.name == of_clock; });
  }
  if (array_of(found, "time") != nullptr) return;
  found.arrays.insert(found.arrays.begin(), clock);
  found.arrays.front().name = "time";
  found.arrays.front().unit = "s";
}

}  // namespace

std::vector<log::LogTable> tables_of(FileArrays found, const std::string& file) {
  name_as_simulink_means(found);
  leave_out_lone_words(found);
  std::vector<Statement> notes = notes_of(found);
  std::set<std::size_t> vector_lengths;
  for (const NamedArray& array : found.arrays) {
    if (!is_matrix(array) && array.rows > 1) vector_lengths.insert(array.rows);
  }
  std::map<std::size_t, std::vector<NamedArray>, std::greater<>> by_length;
  for (NamedArray& array : found.arrays) {
    if (is_scalar(array)) continue;
    if (is_matrix(array)) {
      const Statement note = turn_rows_first(array, vector_lengths);
      if (!note.empty()) notes.push_back(note);
    }
    by_length[array.rows].push_back(std::move(array));
  }
  if (by_length.empty()) refuse_without_rows(notes, file);

  std::vector<log::LogTable> tables;
  std::vector<std::string> first_names;
  for (auto& [rows, arrays] : by_length) {
    log::LogTable& table = tables.emplace_back();
    table.file = file;
    table.rows = rows;
    if (by_length.size() > 1) table.group = common_group(arrays);
    first_names.push_back(arrays.front().name);
    // Vectors keep their names; a matrix's made-up ones give way.
    std::stable_partition(arrays.begin(), arrays.end(),
                          [](const NamedArray& array) { return !is_matrix(array); });
    std::set<std::string> taken;
    for (NamedArray& array : arrays) add_columns(std::move(array), table, taken);
  }
  if (tables.size() > 1) name_groups(tables, first_names);
  log::LogTable& first = tables.front();
  first.notes.insert(first.notes.begin(), notes.begin(), notes.end());
  return tables;
}

bool shape_array(const std::vector<std::uint64_t>& dimensions, NamedArray& array,
                 FileArrays& found) {
  std::vector<std::uint64_t> sides;
  std::string stated;
  std::uint64_t count = 1;
  for (const std::uint64_t side : dimensions) {
    stated += (stated.empty() ? "" : " x ") + std::to_string(side);
    if (side == 0) {
      found.leave_out(array.name, "it is empty");
      return false;
    }
    count = count > most_values / side ? most_values + 1 : count * side;
    if (side != 1) sides.push_back(side);
  }
  if (count > most_values - std::min(found.values, most_values)) {
    found.leave_out(array.name, stated + " numbers are more than 2^31 in one file");
    return false;
  }
  if (sides.size() > 2) {
    found.leave_out(array.name, "it has more than two dimensions: " + stated);
    return false;
  }
  if (sides.size() == 2 && std::min(sides[0], sides[1]) > most_matrix_columns) {
    found.leave_out(array.name, stated + " is no table of samples");
    return false;
  }
  found.values += count;
  array.rows = sides.empty() ? 1 : static_cast<std::size_t>(sides[0]);
  array.columns = sides.size() < 2 ? 1 : static_cast<std::size_t>(sides[1]);
  return true;
}

}  // namespace tribolog::ingest::arrays
