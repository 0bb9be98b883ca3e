#include "ingest/bags/schema_columns.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"

namespace tribolog::ingest::bags {
namespace {

constexpr std::size_t longest_padding = 7;  // some writers of CDR fill up to the next 4 or 8 bytes

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

bool is_number(const MessageField& field, Primitive primitive) {
  return is_one(field, MessageField::Kind::number) && field.primitive == primitive;
}

/// std_msgs/Header: seconds and nanoseconds, behind ROS 1's count of messages, and a text.
bool is_header(const MessageSchema& schema, const MessageType& type, Serialization how) {
  const bool is_ros1 = how == Serialization::ros1;
  const std::size_t first = is_ros1 ? 1 : 0;
  if (type.name != "std_msgs/Header" || type.fields.size() != first + 2) return false;
  if (is_ros1 && !is_number(type.fields[0], Primitive::uint32)) return false;
  if (!is_one(type.fields[first], MessageField::Kind::message) ||
      !is_one(type.fields[first + 1], MessageField::Kind::string)) {
    return false;
  }
  const std::vector<MessageField>& stamp = schema.types[type.fields[first].type].fields;
  return stamp.size() == 2 && is_number(stamp[0], is_ros1 ? Primitive::uint32 : Primitive::int32) &&
         is_number(stamp[1], Primitive::uint32);
}

bool starts_with_header(const MessageSchema& schema, Serialization how) {
  const std::vector<MessageField>& fields = schema.types.front().fields;
  return !fields.empty() && is_one(fields[0], MessageField::Kind::message) &&
         is_header(schema, schema.types[fields[0].type], how);
}

enum class Bytes : std::uint8_t { unknown, none, some };

/// Whether messages of a type take any bytes at all; types within it are found out on the way,
/// which their nesting bounds.
Bytes bytes_of(const MessageSchema& schema, std::size_t type, Serialization how,
               std::vector<Bytes>& known) {
  if (known[type] != Bytes::unknown) return known[type];
  const std::vector<MessageField>& fields = schema.types[type].fields;
  const auto takes_some = [&](const MessageField& field) {
    if (field.count == MessageField::Count::sequence) return true;
    if (field.count == MessageField::Count::fixed && field.elements == 0) return false;
    return field.kind != MessageField::Kind::message ||
           bytes_of(schema, field.type, how, known) == Bytes::some;
  };
  const bool is_padded = fields.empty() && how == Serialization::cdr;
  const bool has_some = is_padded || std::any_of(fields.begin(), fields.end(), takes_some);
  known[type] = has_some ? Bytes::some : Bytes::none;
  return known[type];
}

/// By type. What takes none has no number, and may stand there any number of times.
std::vector<bool> types_with_bytes(const MessageSchema& schema, Serialization how) {
  std::vector<Bytes> known(schema.types.size(), Bytes::unknown);
  std::vector<bool> with_bytes;
  for (std::size_t type = 0; type < schema.types.size(); ++type) {
    with_bytes.push_back(bytes_of(schema, type, how, known) == Bytes::some);
  }
  return with_bytes;
}

std::string shown(std::string_view name) { return "'" + printable(std::string(name)) + "'"; }

}  // namespace

SchemaReader::SchemaReader(MessageSchema schema, Serialization how)
    : schema_(std::move(schema)),
      how_(how),
      has_header_(starts_with_header(schema_, how)),
      with_bytes_(types_with_bytes(schema_, how)) {}

std::optional<std::int64_t> SchemaReader::take_row(std::string_view message,
                                                   messages::MessageColumns& columns) {
  columns_ = &columns;
  CdrReader fields(message, how_);
  std::optional<std::int64_t> stamp_ns;
  if (has_header_) stamp_ns = take_stamp(fields);
  take_fields(fields, schema_.types.front(), has_header_ ? 1 : 0, columns.root());
  const std::size_t padding = how_ == Serialization::cdr ? longest_padding : 0;
  columns.end_row(fields.bytes_left() > padding);
  return stamp_ns;
}

std::optional<std::int64_t> SchemaReader::take_stamp(CdrReader& message) {
  constexpr std::int64_t ns_per_s = 1'000'000'000;
  const bool is_ros1 = how_ == Serialization::ros1;
  if (is_ros1) (void)message.uint32();
  const std::int64_t whole_seconds = is_ros1 ? std::int64_t{message.uint32()} : message.int32();
  const std::int64_t stamp_ns = whole_seconds * ns_per_s + message.uint32();
  (void)message.string();
  return stamp_ns;
}

void SchemaReader::take_fields(CdrReader& message, const MessageType& type, std::size_t first,
                               Place* place) {
  // A message without fields takes one byte of CDR.
  if (type.fields.empty() && how_ == Serialization::cdr) message.skip(Primitive::uint8, 1);
  const NamedElements* const naming = named_elements_of(type);
  std::optional<Names> names;
  for (std::size_t i = first; i < type.fields.size(); ++i) {
    const MessageField& field = type.fields[i];
    const bool is_text = field.kind == MessageField::Kind::string;
    Place* const at = is_text ? nullptr : columns_->field(place, i, field.name);
    const bool is_sequence = field.count == MessageField::Count::sequence;
    if (naming != nullptr && is_sequence && field.name == naming->names && is_text) {
      names = take_names(message);
    } else if (names && is_sequence && !is_text) {
      take_named(message, field, *names, naming->with_field, place, at);
    } else if (field.count == MessageField::Count::one) {
      take_field(message, field, at);
    } else {
      take_elements(message, field, is_sequence ? message.sequence_length() : field.elements, at);
    }
  }
}

void SchemaReader::take_field(CdrReader& message, const MessageField& field, Place* place) {
  switch (field.kind) {
    case MessageField::Kind::number:
      return columns_->put(place, message.number(field.primitive));
    case MessageField::Kind::string:
      (void)message.string();
      return;
    case MessageField::Kind::message:
      break;
  }
  take_fields(message, schema_.types[field.type], 0, place);
}

void SchemaReader::take_elements(CdrReader& message, const MessageField& field, std::size_t count,
                                 Place* place) {
  if (field.kind == MessageField::Kind::message && !with_bytes_[field.type]) return;
  const bool is_long = count > messages::longest_unnamed_array;
  if (is_long && field.kind != MessageField::Kind::string) columns_->leave_out(place);
  if (is_long && field.kind == MessageField::Kind::number) {
    return message.skip(field.primitive, count);
  }
  for (std::size_t i = 0; i < count; ++i) {
    take_field(message, field, is_long ? nullptr : columns_->element(place, i));
  }
}

void SchemaReader::take_named(CdrReader& message, const MessageField& field, const Names& names,
                              bool with_field, Place* parent, Place* place) {
  const std::size_t count = message.sequence_length();
  if (count != 0 && count != names.size()) {
    throw MessageError(fmt::format("has {} elements in {}, where {} have a name", count, field.name,
                                   names.size()));
  }
  for (std::size_t i = 0; i < count; ++i) {
    take_field(message, field,
               columns_->named_element(parent, place, names[i],
                                       with_field ? std::string_view(field.name) : ""));
  }
}

SchemaReader::Names SchemaReader::take_names(CdrReader& message) {
  const std::size_t count = message.sequence_length();
  Names names;
  for (std::size_t i = 0; i < count; ++i) names.push_back(message.string());
  Names sorted = names;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) throw MessageError("names " + shown(*twice) + " twice");
  return names;
}

}  // namespace tribolog::ingest::bags
