#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/input_file.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/json_text.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::arrays {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

bool is_number_or_gap(const JsonValue& value) {
  return value.kind == JsonKind::number || value.kind == JsonKind::null;
}

bool all_are(const JsonValue& array, bool (*wanted)(const JsonValue&)) {
  return std::all_of(array.content->elements.begin(), array.content->elements.end(), wanted);
}

bool is_object(const JsonValue& value) { return value.kind == JsonKind::object; }

bool is_number_list(const JsonValue& value) {
  return value.kind == JsonKind::array && all_are(value, is_number_or_gap);
}

bool are_records(const JsonValue& value) {
  return value.kind == JsonKind::array && !value.content->elements.empty() &&
         all_are(value, is_object);
}

/// Of a text that is a time.
std::optional<text::ClockReading> time_in(const JsonValue& value) {
  if (value.kind != JsonKind::text) return std::nullopt;
  return text::read_iso_time(value.content->text);
}

bool is_time_or_gap(const JsonValue& value) {
  return value.kind == JsonKind::null || time_in(value).has_value();
}

bool is_time_list(const JsonValue& value) {
  return all_are(value, is_time_or_gap) &&
         std::any_of(value.content->elements.begin(), value.content->elements.end(),
                     [](const JsonValue& one) { return one.kind == JsonKind::text; });
}

void append(const JsonValue& value, NamedArray& array) {
  if (const auto time = time_in(value)) {
    if (!std::exchange(array.is_time, true)) array.origin = static_cast<double>(time->whole);
    array.values.push_back(time->since({static_cast<std::int64_t>(array.origin), 0.0}));
    return;
  }
  array.values.push_back(value.kind == JsonKind::number ? value.number : gap);
  array.was_rounded = array.was_rounded || value.was_rounded;
}

void add_vector(const std::string& name, const JsonValue& list, FileArrays& found) {
  NamedArray array;
  array.name = name;
  if (!shape_array({list.content->elements.size()}, array, found)) return;
  for (const JsonValue& value : list.content->elements) append(value, array);
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
    for (const JsonValue& value : list.content->elements) append(value, array);
  }
  found.arrays.push_back(std::move(array));
}

/// A key that stands in fewer of the rows gives no column: a file of n rows with a key of its own
/// each would otherwise take n * n numbers.
constexpr std::size_t most_rows_per_value = 16;

/// What one key of an array of objects says in them all.
struct RecordField {
  NamedArray array;
  std::size_t numbers{};  ///< And gaps.
  std::size_t times{};
  bool has_number{};
  std::string unusable_because{};
  const JsonValue* last_record{};  ///< In which it stands.
  bool is_read{};
};

using FieldIndex = std::map<std::string, std::size_t>;

void count_value(const JsonValue& value, RecordField& field) {
  if (is_number_or_gap(value)) {
    ++field.numbers;
    field.has_number = field.has_number || value.kind == JsonKind::number;
  } else if (time_in(value)) {
    ++field.times;
  } else {
    field.unusable_because =
        value.kind == JsonKind::text ? "it holds texts" : "it holds lists or objects in its rows";
  }
  if (field.has_number && field.times > 0) field.unusable_because = "it holds numbers and times";
}

/// A value within an object, with the name that its column gets.
struct NamedValue {
  std::string name;
  const JsonValue* value;
};

bool is_text(const JsonValue& value) { return value.kind == JsonKind::text; }

/// The joints' names, where an object says them: as JointState does.
const JsonValue* names_in(const JsonValue& object) {
  for (std::size_t i = 0; i < object.content->keys.size(); ++i) {
    const std::string& key = object.content->keys[i];
    const JsonValue& value = object.content->elements[i];
    const bool is_list = value.kind == JsonKind::array && !value.content->elements.empty();
    if (is_list && (key == "name" || key == "names" || key == "joint_names") &&
        all_are(value, is_text)) {
      return &value;
    }
  }
  return nullptr;
}

/// The single values in an object, those in objects within it with a path in front: "stamp.sec".
/// The numbers of a list are "elbow.position" where the object names as many joints, else
/// "position_0" and so on.
void list_values(const std::string& prefix, const JsonValue& object,
                 std::vector<NamedValue>& values) {
  constexpr std::size_t longest_list = 64;
  const JsonValue* names = names_in(object);
  for (std::size_t i = 0; i < object.content->keys.size(); ++i) {
    const std::string& key = object.content->keys[i];
    const JsonValue& value = object.content->elements[i];
    if (&value == names) continue;
    if (is_object(value)) {
      list_values(prefix + key + ".", value, values);
      continue;
    }
    const std::size_t length = is_number_list(value) ? value.content->elements.size() : 0;
    if (length == 0 || length > longest_list) {
      values.push_back({prefix + key, &value});
      continue;
    }
    const bool are_named = names != nullptr && names->content->elements.size() == length;
    for (std::size_t k = 0; k < length; ++k) {
      values.push_back({are_named ? names->content->elements[k].content->text + "." + key
                                  : prefix + key + "_" + std::to_string(k),
                        &value.content->elements[k]});
    }
  }
}

std::vector<RecordField> fields_of(const std::string& prefix, const JsonValue& records,
                                   FieldIndex& index) {
  std::vector<RecordField> fields;
  std::vector<NamedValue> values;
  for (const JsonValue& record : records.content->elements) {
    values.clear();
    list_values("", record, values);
    for (const NamedValue& one : values) {
      const auto [entry, is_new] = index.emplace(one.name, fields.size());
      if (is_new) fields.emplace_back().array.name = prefix + one.name;
      RecordField& field = fields[entry->second];
      if (field.last_record == &record) field.unusable_because = "it stands twice in a row";
      field.last_record = &record;
      count_value(*one.value, field);
    }
  }
  return fields;
}

void fill(const JsonValue& records, const FieldIndex& index, std::vector<RecordField>& fields) {
  std::size_t row = 0;
  std::vector<NamedValue> values;
  for (const JsonValue& record : records.content->elements) {
    values.clear();
    list_values("", record, values);
    for (const NamedValue& one : values) {
      RecordField& field = fields[index.at(one.name)];
      if (!field.is_read) continue;
      field.array.values.resize(row, gap);  // rows that lack the key
      append(*one.value, field.array);
    }
    ++row;
  }
}

void add_records(const std::string& prefix, const JsonValue& records, FileArrays& found) {
  FieldIndex index;
  std::vector<RecordField> fields = fields_of(prefix, records, index);
  const std::size_t rows = records.content->elements.size();
  for (RecordField& field : fields) {
    if (field.unusable_because.empty() &&
        field.numbers + field.times < rows / most_rows_per_value) {
      field.unusable_because = "it stands in " + std::to_string(field.numbers + field.times) +
                               " of " + std::to_string(rows) + " rows";
    }
    if (!field.unusable_because.empty()) {
      found.leave_out(field.array.name, field.unusable_because);
    } else {
      field.is_read = shape_array({rows}, field.array, found);
    }
  }
  fill(records, index, fields);
  for (RecordField& field : fields) {
    if (!field.is_read) continue;
    field.array.values.resize(rows, gap);
    found.arrays.push_back(std::move(field.array));
  }
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
    RecordField field;
    field.array.name = prefix + names[k].content->text;
    for (const JsonValue& row : rows) count_value(row.content->elements[k], field);
    if (!field.unusable_because.empty()) {
      found.leave_out(field.array.name, field.unusable_because);
      continue;
    }
    if (!shape_array({rows.size()}, field.array, found)) continue;
    for (const JsonValue& row : rows) append(row.content->elements[k], field.array);
    found.arrays.push_back(std::move(field.array));
  }
}

void add_labelled_column(const std::string& name, const JsonValue& value, FileArrays& found) {
  if (!all_are(value, is_number_or_gap) && !is_time_list(value))
    return found.leave_out(name, "it holds texts");
  add_vector(name, value, found);
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
      append(value, scalar);
      found.arrays.push_back(std::move(scalar));
      return;
    }
    case JsonKind::object:
      if (is_split_table(value))
        return add_split_table(name.empty() ? "" : name + "/", value, found);
      if (is_labelled_column(value)) return add_labelled_column(shown, value, found);
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
  return tables_of(std::move(found), file);
}

std::vector<log::LogTable> read_bam_json(const std::string& path) {
  return parse_json_log(read_file(path, largest_json_bytes), path);
}

}  // namespace tribolog::ingest::arrays
