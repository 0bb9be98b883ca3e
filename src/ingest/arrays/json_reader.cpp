#include <algorithm>
#include <limits>
#include <map>

#include "base/input_file.h"
#include "ingest/arrays/array_readers.h"
#include "ingest/arrays/array_tables.h"
#include "ingest/arrays/json_text.h"

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

void append(const JsonValue& value, NamedArray& array) {
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
  std::size_t numbers{};
  std::string unusable_because{};
  bool is_read{};
};

using FieldIndex = std::map<std::string, std::size_t>;

void count_value(const JsonValue& value, RecordField& field) {
  if (is_number_or_gap(value)) {
    ++field.numbers;
  } else {
    field.unusable_because =
        value.kind == JsonKind::text ? "it holds texts" : "it holds lists or objects in its rows";
  }
}

std::vector<RecordField> fields_of(const std::string& prefix, const JsonValue& records,
                                   FieldIndex& index) {
  std::vector<RecordField> fields;
  for (const JsonValue& record : records.content->elements) {
    for (std::size_t i = 0; i < record.content->keys.size(); ++i) {
      const std::string& key = record.content->keys[i];
      const auto [entry, is_new] = index.emplace(key, fields.size());
      if (is_new) fields.emplace_back().array.name = prefix + key;
      count_value(record.content->elements[i], fields[entry->second]);
    }
  }
  return fields;
}

void fill(const JsonValue& records, const FieldIndex& index, std::vector<RecordField>& fields) {
  std::size_t row = 0;
  for (const JsonValue& record : records.content->elements) {
    for (std::size_t i = 0; i < record.content->keys.size(); ++i) {
      RecordField& field = fields[index.at(record.content->keys[i])];
      if (!field.is_read) continue;
      field.array.values.resize(row, gap);  // rows that lack the key
      append(record.content->elements[i], field.array);
    }
    ++row;
  }
}

void add_records(const std::string& prefix, const JsonValue& records, FileArrays& found) {
  FieldIndex index;
  std::vector<RecordField> fields = fields_of(prefix, records, index);
  const std::size_t rows = records.content->elements.size();
  for (RecordField& field : fields) {
    if (field.unusable_because.empty() && field.numbers < rows / most_rows_per_value) {
      field.unusable_because =
          "it stands in " + std::to_string(field.numbers) + " of " + std::to_string(rows) + " rows";
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

std::size_t count_records(const JsonValue& value) {
  if (are_records(value)) return 1;
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
  if (is_number_list(value)) return add_vector(shown, value, found);
  if (all_are(value, is_number_list)) return add_matrix(shown, value, found);
  found.leave_out(shown, "it is a list of texts or of mixed values");
}

}  // namespace

std::vector<log::LogTable> parse_json_log(std::string_view bytes, const std::string& file) {
  const JsonValue root = parse_json_text(bytes, file);
  FileArrays found;
  add_value("", root, count_records(root) == 1, found);
  return tables_of(std::move(found), file);
}

std::vector<log::LogTable> read_bam_json(const std::string& path) {
  return parse_json_log(read_file(path, largest_json_bytes), path);
}

}  // namespace tribolog::ingest::arrays
