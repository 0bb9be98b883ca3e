#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/bags/topic_tables.h"

namespace tribolog::ingest::bags {
namespace {

constexpr std::size_t longest_unnamed_array = 64;
constexpr std::size_t most_columns = 5000;
constexpr std::size_t most_places = 4 * most_columns;
constexpr std::size_t longest_padding = 7;  // some writers fill up to the next 4 or 8 bytes
constexpr std::size_t no_column = std::numeric_limits<std::size_t>::max();

/// A type that names the elements of its arrays.
struct NamedElements {
  std::string_view type;
  std::string_view names;
  bool with_field;  ///< The field's name follows the element's.
};

constexpr std::array named_elements = {
    NamedElements{"sensor_msgs/JointState", "name", true},
    NamedElements{"control_msgs/DynamicJointState", "joint_names", false},
    NamedElements{"control_msgs/InterfaceValue", "interface_names", false},
};

const NamedElements* named_elements_of(const MessageType& type) {
  for (const NamedElements& entry : named_elements) {
    if (entry.type == type.name) return &entry;
  }
  return nullptr;
}

bool is_one(const MessageField& field, MessageField::Kind kind) {
  return field.kind == kind && field.count == MessageField::Count::one;
}

/// std_msgs/Header with its stamp of int32 s and uint32 ns.
bool is_header(const MessageSchema& schema, const MessageType& type) {
  using Kind = MessageField::Kind;
  if (type.name != "std_msgs/Header" || type.fields.size() != 2) return false;
  if (!is_one(type.fields[0], Kind::message) || !is_one(type.fields[1], Kind::string)) return false;
  const std::vector<MessageField>& stamp = schema.types[type.fields[0].type].fields;
  return stamp.size() == 2 && is_one(stamp[0], Kind::number) && is_one(stamp[1], Kind::number) &&
         stamp[0].primitive == Primitive::int32 && stamp[1].primitive == Primitive::uint32;
}

std::string joined(const std::string& path, std::string_view name) {
  return path.empty() ? std::string(name) : path + "." + std::string(name);
}

std::string shown(std::string_view name) { return "'" + printable(std::string(name)) + "'"; }

}  // namespace

struct MessageColumns::Place {
  std::string path;
  std::size_t column{no_column};
  std::vector<std::unique_ptr<Place>> parts;  ///< Fields, or elements by number.
  std::map<std::string, std::unique_ptr<Place>, std::less<>> named;
};

MessageColumns::MessageColumns(MessageSchema schema)
    : schema_(std::move(schema)), root_(std::make_unique<Place>()) {}
MessageColumns::~MessageColumns() = default;

std::optional<std::int64_t> MessageColumns::take_row(CdrReader& message) {
  const MessageType& type = schema_.types.front();
  const std::optional<std::int64_t> stamp_ns = take_stamp(message, type);
  take_fields(message, type, stamp_ns ? 1 : 0, root_.get());
  if (message.bytes_left() > longest_padding) ++too_long_;
  ++rows_;
  return stamp_ns;
}

std::optional<std::int64_t> MessageColumns::take_stamp(CdrReader& message,
                                                       const MessageType& type) {
  if (type.fields.empty() || !is_one(type.fields[0], MessageField::Kind::message) ||
      !is_header(schema_, schema_.types[type.fields[0].type])) {
    return std::nullopt;
  }
  constexpr std::int64_t ns_per_s = 1'000'000'000;
  const std::int64_t whole_seconds = message.int32();
  const std::int64_t stamp_ns = whole_seconds * ns_per_s + message.uint32();
  (void)message.string();
  return stamp_ns;
}

void MessageColumns::take_fields(CdrReader& message, const MessageType& type, std::size_t first,
                                 Place* place) {
  // A message without fields takes one byte.
  if (type.fields.empty()) message.skip(Primitive::uint8, 1);
  const NamedElements* const naming = named_elements_of(type);
  std::optional<Names> names;
  for (std::size_t i = first; i < type.fields.size(); ++i) {
    const MessageField& field = type.fields[i];
    Place* const at = field_of(place, i, field);
    const bool is_sequence = field.count == MessageField::Count::sequence;
    if (naming != nullptr && is_sequence && field.name == naming->names &&
        field.kind == MessageField::Kind::string) {
      names = take_names(message);
    } else if (names && is_sequence && field.kind != MessageField::Kind::string) {
      take_named(message, field, message.sequence_length(), *names, naming->with_field, place, at);
    } else if (field.count == MessageField::Count::one) {
      take_field(message, field, at);
    } else {
      take_elements(message, field, is_sequence ? message.sequence_length() : field.elements, at);
    }
  }
}

void MessageColumns::take_field(CdrReader& message, const MessageField& field, Place* place) {
  switch (field.kind) {
    case MessageField::Kind::number:
      return put(place, message.number(field.primitive));
    case MessageField::Kind::string:
      (void)message.string();
      return;
    case MessageField::Kind::message:
      break;
  }
  take_fields(message, schema_.types[field.type], 0, place);
}

void MessageColumns::take_elements(CdrReader& message, const MessageField& field, std::size_t count,
                                   Place* place) {
  const bool is_long = count > longest_unnamed_array;
  if (is_long && place != nullptr && field.kind != MessageField::Kind::string &&
      std::find(long_arrays_.begin(), long_arrays_.end(), place->path) == long_arrays_.end()) {
    long_arrays_.push_back(place->path);
  }
  if (is_long && field.kind == MessageField::Kind::number) {
    return message.skip(field.primitive, count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    take_field(message, field, is_long ? nullptr : element_of(place, i));
  }
}

void MessageColumns::take_named(CdrReader& message, const MessageField& field, std::size_t count,
                                const Names& names, bool with_field, Place* parent, Place* place) {
  if (count != 0 && count != names.size()) {
    throw CdrError(fmt::format("has {} elements in {}, where {} have a name", count, field.name,
                               names.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    Place* at = nullptr;
    if (place != nullptr) {
      auto found = place->named.find(names[i]);
      if (found == place->named.end() && places_ < most_places) {
        found = place->named.emplace(std::string(names[i]), nullptr).first;
        const std::string path = joined(parent->path, names[i]);
        added(found->second, with_field ? joined(path, field.name) : path);
      } else if (found == place->named.end()) {
        has_too_many_columns_ = true;
      }
      if (found != place->named.end()) at = found->second.get();
    }
    take_field(message, field, at);
  }
}

MessageColumns::Names MessageColumns::take_names(CdrReader& message) {
  const std::size_t count = message.sequence_length();
  Names names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(message.string());
  Names sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) throw CdrError("names " + shown(*twice) + " twice");
  return names;
}

void MessageColumns::put(Place* place, double value) {
  if (place == nullptr) return;
  if (place->column == no_column) {
    if (columns_.size() == most_columns) {
      has_too_many_columns_ = true;
      return;
    }
    place->column = columns_.size();
    columns_.push_back({{place->path, place->path, ""}, {}, 0});
  }
  std::vector<double>& values = columns_[place->column].values;
  values.resize(rows_, std::numeric_limits<double>::quiet_NaN());
  values.push_back(std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN());
}

MessageColumns::Place* MessageColumns::field_of(Place* parent, std::size_t index,
                                                const MessageField& field) {
  if (parent == nullptr || field.kind == MessageField::Kind::string) return nullptr;
  if (parent->parts.size() <= index) parent->parts.resize(index + 1);
  std::unique_ptr<Place>& part = parent->parts[index];
  return part ? part.get() : added(part, joined(parent->path, field.name));
}

MessageColumns::Place* MessageColumns::element_of(Place* parent, std::size_t index) {
  if (parent == nullptr) return nullptr;
  if (parent->parts.size() <= index) parent->parts.resize(index + 1);
  std::unique_ptr<Place>& part = parent->parts[index];
  return part ? part.get() : added(part, fmt::format("{}[{}]", parent->path, index));
}

MessageColumns::Place* MessageColumns::added(std::unique_ptr<Place>& where, std::string path) {
  if (places_ == most_places) {
    has_too_many_columns_ = true;
    return nullptr;
  }
  ++places_;
  where = std::make_unique<Place>();
  where->path = std::move(path);
  return where.get();
}

std::vector<log::LogColumn> MessageColumns::finish() && {
  for (log::LogColumn& column : columns_) {
    column.values.resize(rows_, std::numeric_limits<double>::quiet_NaN());
    column.gaps =
        static_cast<std::size_t>(std::count_if(column.values.begin(), column.values.end(),
                                               [](double value) { return std::isnan(value); }));
  }
  return std::move(columns_);
}

}  // namespace tribolog::ingest::bags
