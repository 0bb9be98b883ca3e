#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_file.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/json_records.h"
#include "ingest/arrays/json_text.h"
#include "ingest/arrays/long_format.h"

namespace tribolog::ingest::arrays {
namespace {

bool are_records(const JsonValue& value) {
  return value.kind == JsonKind::array && !value.content->elements.empty() &&
         all_are(value, is_object);
}

bool is_time_or_gap(const JsonValue& value) {
  return value.kind == JsonKind::null || is_iso_time(value);
}

bool is_time_list(const JsonValue& value) {
  return all_are(value, is_time_or_gap) &&
         std::any_of(value.content->elements.begin(), value.content->elements.end(),
                     [](const JsonValue& one) { return one.kind == JsonKind::text; });
}

void add_vector(const std::string& name, const JsonValue& list, FileArrays& found) {
  NamedArray array;
  array.name = name;
  if (!shape_array({list.content->elements.size()}, array, found)) return;
  for (const JsonValue& value : list.content->elements) append_number(value, array);
  found.arrays.push_back(std::move(array));
}

void add_matrix(const std::string& name, const JsonValue& lists, FileArrays& found) {
  NamedArray array;
  array.name = name;
  const std::size_t width = lists.content->elements.front().content->elements.size();
  for (const JsonValue& list : lists.content->elements) {
    if (list.content->elements.size() != width) {
      return found.leave_out(name, "its lists are of different length");
    }
  }
  if (!shape_array({lists.content->elements.size(), width}, array, found)) return;
  for (const JsonValue& list : lists.content->elements) {
    for (const JsonValue& value : list.content->elements) append_number(value, array);
  }
  found.arrays.push_back(std::move(array));
}

// Tables as pandas writes them, in each of its orientations.

bool is_row_label(const std::string& key) {
  return !key.empty() &&
         std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// {"0": {"t": 0, ...}, "1": ...}: a row each, by its label.
bool are_labelled_records(const JsonValue& value) {
  return is_object(value) && value.content->keys.size() > 1 && all_are(value, is_object) &&
         std::all_of(value.content->keys.begin(), value.content->keys.end(), is_row_label);
}

/// {"0": 0.1, "1": 0.2, ...}: a column, by the labels of its rows.
bool is_labelled_column(const JsonValue& value) {
  return is_object(value) && value.content->keys.size() > 1 &&
         std::all_of(value.content->keys.begin(), value.content->keys.end(), is_row_label) &&
         std::none_of(
             value.content->elements.begin(), value.content->elements.end(),
             [](const JsonValue& one) { return is_object(one) || one.kind == JsonKind::array; });
}

const JsonValue* member(const JsonValue& object, const char* key) {
  const auto& keys = object.content->keys;
  const auto found = std::find(keys.begin(), keys.end(), key);
  return found == keys.end() ? nullptr : &object.content->elements[found - keys.begin()];
}

/// {"columns": ["t", ...], "index": [...], "data": [[0, ...], ...]}
bool is_split_table(const JsonValue& value) {
  if (!is_object(value)) return false;
  const JsonValue* columns = member(value, "columns");
  const JsonValue* data = member(value, "data");
  const auto is_list = [](const JsonValue* one) {
    return one != nullptr && one->kind == JsonKind::array && !one->content->elements.empty();
  };
  const auto is_row = [&](const JsonValue& row) {
    return row.kind == JsonKind::array &&
           row.content->elements.size() == columns->content->elements.size();
  };
  return is_list(columns) && is_list(data) && all_are(*columns, is_text) &&
         std::all_of(data->content->elements.begin(), data->content->elements.end(), is_row);
}

void add_split_table(const std::string& prefix, const JsonValue& value, FileArrays& found) {
  const auto& rows = member(value, "data")->content->elements;
  const auto& names = member(value, "columns")->content->elements;
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::vector<const JsonValue*> column;
    for (const JsonValue& row : rows) column.push_back(&row.content->elements[k]);
    add_column(prefix + names[k].content->text, column, found);
  }
}

void add_list(const std::string& name, const JsonValue& list, FileArrays& found) {
  std::vector<const JsonValue*> column;
  for (const JsonValue& value : list.content->elements) column.push_back(&value);
  add_column(name, column, found);
}

/// A list of words that come again: no names of joints, say, but a column.
bool is_column_of_words(const JsonValue& value) {
  constexpr std::size_t fewest = 20;  // rows
  if (value.kind != JsonKind::array || value.content->elements.size() < fewest) return false;
  std::set<std::string_view> words;
  for (const JsonValue& one : value.content->elements) {
    if (one.kind == JsonKind::text) words.insert(one.content->text);
    if (one.kind != JsonKind::text && one.kind != JsonKind::null) return false;
  }
  return 2 * words.size() <= value.content->elements.size();
}

std::size_t count_records(const JsonValue& value) {
  if (are_records(value) || are_labelled_records(value)) return 1;
  std::size_t count = 0;
  if (is_object(value)) {
    for (const JsonValue& element : value.content->elements) count += count_records(element);
  }
  return count;
}

/// @param only_records there is one array of objects: its keys need no name in front.
void add_value(const std::string& name, const JsonValue& value, bool only_records,
               FileArrays& found) {
  const std::string shown = name.empty() ? "value" : name;
  switch (value.kind) {
    case JsonKind::null:
      return found.leave_out(shown, "it is null");
    case JsonKind::text:
      found.texts.emplace_back(shown, value.content->text);
      return;
    case JsonKind::number: {
      NamedArray scalar;
      scalar.name = shown;
      if (!shape_array({}, scalar, found)) return;
      append_number(value, scalar);
      found.arrays.push_back(std::move(scalar));
      return;
    }
    case JsonKind::object:
      if (is_split_table(value))
        return add_split_table(name.empty() ? "" : name + "/", value, found);
      if (is_labelled_column(value)) return add_list(shown, value, found);
      if (are_labelled_records(value)) {
        return add_records(only_records || name.empty() ? "" : name + "/", value, found);
      }
      for (std::size_t i = 0; i < value.content->keys.size(); ++i) {
        const std::string inner =
            name.empty() ? value.content->keys[i] : name + "." + value.content->keys[i];
        add_value(inner, value.content->elements[i], only_records, found);
      }
      return;
    case JsonKind::array:
      break;
  }
  if (are_records(value)) {
    return add_records(only_records || name.empty() ? "" : name + "/", value, found);
  }
  if (is_number_list(value) || is_time_list(value)) return add_vector(shown, value, found);
  if (is_column_of_words(value)) return add_list(shown, value, found);
  if (all_are(value, is_number_list)) return add_matrix(shown, value, found);
  found.leave_out(shown, "it is a list of texts or of mixed values");
}

constexpr std::string_view blanks = " \t\r\n";

/// JSON Lines: an object behind the other, a line each.
bool are_json_lines(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos || text[begin] != '{') return false;
  const std::size_t end = text.find('\n', begin);
  if (end == std::string_view::npos) return false;
  const std::size_t last = text.find_last_not_of(blanks, end);
  const std::size_t next = text.find_first_not_of(blanks, end);
  return text[last] == '}' && next != std::string_view::npos && text[next] == '{';
}

/// The lines as one array; each stays the line that it is.
std::string array_of_lines(std::string_view text) {
  std::string array = "[";
  array.reserve(text.size() + text.size() / 16);
  bool has_one = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    const bool is_blank = line.find_first_not_of(blanks) == std::string_view::npos;
    if (!is_blank && has_one) array += ',';
    has_one = has_one || !is_blank;
    array.append(line);
    if (end < text.size()) array += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return array + "]";
}

}  // namespace

std::vector<log::LogTable> parse_json_log(std::string_view bytes, const std::string& file) {
  const JsonValue root = are_json_lines(bytes) ? parse_json_text(array_of_lines(bytes), file)
                                               : parse_json_text(bytes, file);
  FileArrays found;
  add_value("", root, count_records(root) == 1, found);
  const std::vector<Statement> notes = spread_signals(found);
  std::vector<log::LogTable> tables = tables_of(std::move(found), file);
  tables.front().notes.insert(tables.front().notes.begin(), notes.begin(), notes.end());
  return tables;
}

std::vector<log::LogTable> read_bam_json(const std::string& path) {
  return parse_json_log(read_file(path, largest_json_bytes), path);
}

}  // namespace tribolog::ingest::arrays
