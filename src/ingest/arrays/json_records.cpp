#include "ingest/arrays/json_records.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "ingest/text/fields.h"

namespace tribolog::ingest::arrays {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

std::optional<text::ClockReading> iso_time_in(const JsonValue& value) {
  if (value.kind != JsonKind::text) return std::nullopt;
  return text::read_iso_time(value.content->text);
}

}  // namespace

bool is_iso_time(const JsonValue& value) { return iso_time_in(value).has_value(); }

void append_number(const JsonValue& value, NamedArray& array) {
  if (const auto time = iso_time_in(value)) {
    if (!std::exchange(array.is_time, true)) array.origin = static_cast<double>(time->whole);
    array.values.push_back(time->since({static_cast<std::int64_t>(array.origin), 0.0}));
    return;
  }
  array.values.push_back(value.kind == JsonKind::number ? value.number : no_number);
  array.was_rounded = array.was_rounded || value.was_rounded;
}

namespace {

/// A key that stands in fewer of the rows gives no column: a file of n rows with a key of its own
/// each would otherwise take n * n numbers.
constexpr std::size_t most_rows_per_value = 16;

/// Of one column; a log in which each row says something else has no words.
constexpr std::size_t most_words = 4096;

/// What stands under one name: looked at first, then read.
class JsonColumn {
 public:
  explicit JsonColumn(std::string name) { array_.name = std::move(name); }

  void look_at(const JsonValue& value) {
    ++count_;
    if (is_number_or_gap(value)) {
      has_number_ = has_number_ || value.kind == JsonKind::number;
    } else if (is_iso_time(value)) {
      has_time_ = true;
    } else if (is_text(value)) {
      if (places_.size() <= most_words) places_.emplace(value.content->text, places_.size());
    } else {
      unusable_because_ = "it holds lists or objects in its rows";
    }
  }
  void stands_twice() { unusable_because_ = "it stands twice in a row"; }

  /// Whether it is to be read; if not, it is left out with the reason.
  bool settle(std::size_t rows, FileArrays& found) {
    if (count_ < rows / most_rows_per_value) {
      unusable_because_ =
          "it stands in " + std::to_string(count_) + " of " + std::to_string(rows) + " rows";
    } else if (unusable_because_.empty() && has_number_ && has_time_) {
      unusable_because_ = "it holds numbers and times";
    } else if (unusable_because_.empty() && !places_.empty()) {
      const bool are_words = !has_number_ && !has_time_ && places_.size() <= most_words && rows > 1;
      if (!are_words) unusable_because_ = "it holds texts";
    }
    if (!unusable_because_.empty()) {
      found.leave_out(array_.name, unusable_because_);
      return false;
    }
    is_read_ = shape_array({rows}, array_, found);
    if (!is_read_) return false;
    array_.words.resize(places_.size());
    for (const auto& [word, place] : places_) array_.words[place] = word;
    return true;
  }

  /// @param row rows before it that lack the value are gaps.
  void read(const JsonValue& value, std::size_t row) {
    if (!is_read_) return;
    array_.values.resize(row, no_number);
    if (!places_.empty() && is_text(value)) {
      array_.values.push_back(static_cast<double>(places_.at(value.content->text)));
    } else {
      append_number(value, array_);
    }
  }

  void hand_over(std::size_t rows, FileArrays& found) {
    if (!is_read_) return;
    array_.values.resize(rows, no_number);
    found.arrays.push_back(std::move(array_));
  }

 private:
  NamedArray array_;
  std::size_t count_{};
  bool has_number_{};
  bool has_time_{};
  std::unordered_map<std::string, std::size_t> places_;  ///< Of the words.
  std::string unusable_because_;
  bool is_read_{};
};

}  // namespace

void add_column(const std::string& name, const std::vector<const JsonValue*>& values,
                FileArrays& found) {
  JsonColumn column(name);
  for (const JsonValue* value : values) column.look_at(*value);
  if (!column.settle(values.size(), found)) return;
  for (std::size_t row = 0; row < values.size(); ++row) column.read(*values[row], row);
  column.hand_over(values.size(), found);
}

// Where the values of a record stand, and what they are called. Nearly all records of a log are
// alike: the names are made for the first, and again where one is not like the one before it.

namespace {

constexpr std::size_t longest_list = 64;

/// A value within an object, with the name that its column gets.
struct NamedValue {
  std::string name;
  const JsonValue* value;
};

/// What an object holds, without its numbers.
struct ObjectShape {
  enum class Member { single, list, joint_names, object };
  std::vector<std::string> keys;
  std::vector<Member> members;             ///< Of each key.
  std::vector<std::size_t> lengths;        ///< Of each key; 0 for what is no list.
  std::vector<std::string> joint_names;    ///< Of the one list that there may be.
  std::vector<ObjectShape> inner_objects;  ///< In the order of their keys.
};

/// Index of the key whose value says the joints' names, as JointState does.
std::optional<std::size_t> names_in(const JsonValue& object) {
  for (std::size_t i = 0; i < object.content->keys.size(); ++i) {
    const std::string& key = object.content->keys[i];
    const JsonValue& value = object.content->elements[i];
    const bool is_list = value.kind == JsonKind::array && !value.content->elements.empty();
    if (is_list && (key == "name" || key == "names" || key == "joint_names") &&
        all_are(value, is_text)) {
      return i;
    }
  }
  return std::nullopt;
}

/// Lists the values with their names as add_records() says. @return the object's shape.
ObjectShape list_values(const std::string& prefix, const JsonValue& object,
                        std::vector<NamedValue>& values) {
  ObjectShape shape;
  shape.keys = object.content->keys;
  const auto names = names_in(object);
  if (names) {
    for (const JsonValue& name : object.content->elements[*names].content->elements) {
      shape.joint_names.push_back(name.content->text);
    }
  }
  for (std::size_t i = 0; i < shape.keys.size(); ++i) {
    const std::string& key = shape.keys[i];
    const JsonValue& value = object.content->elements[i];
    shape.members.push_back(ObjectShape::Member::single);
    shape.lengths.push_back(0);
    if (i == names) {
      shape.members.back() = ObjectShape::Member::joint_names;
      continue;
    }
    if (is_object(value)) {
      shape.members.back() = ObjectShape::Member::object;
      shape.inner_objects.push_back(list_values(prefix + key + ".", value, values));
      continue;
    }
    const std::size_t length = is_number_list(value) ? value.content->elements.size() : 0;
    if (length == 0 || length > longest_list) {
      values.push_back({prefix + key, &value});
      continue;
    }
    shape.members.back() = ObjectShape::Member::list;
    shape.lengths.back() = length;
    const bool are_named = shape.joint_names.size() == length;
    for (std::size_t k = 0; k < length; ++k) {
      values.push_back(
          {are_named ? shape.joint_names[k] + "." + key : prefix + key + "_" + std::to_string(k),
           &value.content->elements[k]});
    }
  }
  return shape;
}

/// Lists the values of an object in the order of list_values().
/// @return false where it has not the shape; some values are listed then.
bool list_alike(const ObjectShape& shape, const JsonValue& object,
                std::vector<const JsonValue*>& values) {
  if (object.content->keys != shape.keys) return false;
  std::size_t inner = 0;
  for (std::size_t i = 0; i < shape.keys.size(); ++i) {
    const JsonValue& value = object.content->elements[i];
    switch (shape.members[i]) {
      case ObjectShape::Member::single:
        // Of lists that are no numbers, or very long ones, a closer look tells what they are.
        if (is_object(value)) return false;
        if (value.kind == JsonKind::array && !value.content->elements.empty()) return false;
        values.push_back(&value);
        break;
      case ObjectShape::Member::list:
        if (!is_number_list(value) || value.content->elements.size() != shape.lengths[i]) {
          return false;
        }
        for (const JsonValue& one : value.content->elements) values.push_back(&one);
        break;
      case ObjectShape::Member::joint_names: {
        const auto is_same = [](const JsonValue& one, const std::string& name) {
          return is_text(one) && one.content->text == name;
        };
        if (value.kind != JsonKind::array ||
            !std::equal(value.content->elements.begin(), value.content->elements.end(),
                        shape.joint_names.begin(), shape.joint_names.end(), is_same)) {
          return false;
        }
        break;
      }
      case ObjectShape::Member::object:
        if (!is_object(value) || !list_alike(shape.inner_objects[inner++], value, values)) {
          return false;
        }
        break;
    }
  }
  return true;
}

class Records {
 public:
  Records(std::string prefix, const JsonValue& records)
      : prefix_(std::move(prefix)), records_(records) {}

  void add_to(FileArrays& found) {
    for_each_value(
        [](JsonColumn& column, const JsonValue& value, std::size_t) { column.look_at(value); });
    const std::size_t rows = records_.content->elements.size();
    for (JsonColumn& column : columns_) column.settle(rows, found);
    for_each_value([](JsonColumn& column, const JsonValue& value, std::size_t row) {
      column.read(value, row);
    });
    for (JsonColumn& column : columns_) column.hand_over(rows, found);
  }

 private:
  template <class Use>
  void for_each_value(const Use& use) {
    for (std::size_t row = 0; row < records_.content->elements.size(); ++row) {
      const JsonValue& record = records_.content->elements[row];
      values_.clear();
      if (!is_laid_out_ || !list_alike(shape_, record, values_)) lay_out(record);
      for (std::size_t k = 0; k < values_.size(); ++k) {
        use(columns_[column_of_value_[k]], *values_[k], row);
      }
    }
  }

  void lay_out(const JsonValue& record) {
    std::vector<NamedValue> named;
    std::unordered_set<std::size_t> used;
    shape_ = list_values("", record, named);
    is_laid_out_ = true;
    values_.clear();
    column_of_value_.clear();
    for (const NamedValue& one : named) {
      const auto [entry, is_new] = index_.emplace(one.name, columns_.size());
      if (is_new) columns_.emplace_back(prefix_ + one.name);
      const std::size_t column = entry->second;
      if (!used.insert(column).second) columns_[column].stands_twice();
      values_.push_back(one.value);
      column_of_value_.push_back(column);
    }
  }

  std::string prefix_;
  const JsonValue& records_;
  std::unordered_map<std::string, std::size_t> index_;  ///< Of the columns, by their names.
  std::vector<JsonColumn> columns_;
  bool is_laid_out_{};
  ObjectShape shape_;                         ///< Of the last record,
  std::vector<const JsonValue*> values_;      ///< what it holds,
  std::vector<std::size_t> column_of_value_;  ///< and in which column that stands.
};

}  // namespace

void add_records(const std::string& prefix, const JsonValue& records, FileArrays& found) {
  Records(prefix, records).add_to(found);
}

}  // namespace tribolog::ingest::arrays
