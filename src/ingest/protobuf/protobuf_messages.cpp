#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <google/protobuf/dynamic_message.h>
#include <google/protobuf/message.h>

#include "base/error.h"
#include "ingest/messages/protobuf_decoder.h"
#include "ingest/messages/topic_tables.h"
#include "ingest/protobuf/descriptor_set.h"

#if GOOGLE_PROTOBUF_VERSION < 4022000  // later ones log by Abseil
#include <google/protobuf/stubs/logging.h>
#endif

namespace tribolog::ingest::protobuf {
namespace {

namespace pb = google::protobuf;
using messages::MessageError;
using messages::MessageTree;
using messages::SchemaError;
using CppType = pb::FieldDescriptor::CppType;

/// Most types that a message may hold, itself included.
constexpr std::size_t most_types = 1000;
/// Most bytes that a message may take in memory.
constexpr std::uint64_t largest_message_bytes = std::uint64_t{1} << 30;
/// An element of an array takes at least so much on the wire.
constexpr std::uint64_t least_element_bytes = 2;

/// Types of the messages within a message, itself first.
std::vector<const pb::Descriptor*> types_within(const pb::Descriptor& type) {
  std::vector<const pb::Descriptor*> types = {&type};
  std::set<const pb::Descriptor*> known = {&type};
  for (std::size_t i = 0; i < types.size(); ++i) {
    for (int k = 0; k < types[i]->field_count(); ++k) {
      const pb::Descriptor* const inner = types[i]->field(k)->message_type();
      if (inner != nullptr && known.insert(inner).second) types.push_back(inner);
    }
    if (types.size() > most_types) {
      throw SchemaError(fmt::format("its messages hold more than {} types", most_types));
    }
  }
  return types;
}

/// The compiler's own way of asking is newer than some distributions.
template <class Field>
bool has_presence(const Field& field) {
  if constexpr (requires { field.has_presence(); }) {
    return field.has_presence();
  } else {
    return field.cpp_type() == CppType::CPPTYPE_MESSAGE || field.containing_oneof() != nullptr ||
           field.file()->syntax() == pb::FileDescriptor::SYNTAX_PROTO2;
  }
}

/// google.protobuf.DoubleValue and the like: its one field.
const pb::FieldDescriptor* wrapped_field(const pb::Descriptor& type) {
  const std::string_view name = type.full_name();
  const bool is_wrapper = name.starts_with("google.protobuf.") && name.ends_with("Value") &&
                          type.field_count() == 1 && type.field(0)->name() == "value";
  return is_wrapper && !type.field(0)->is_repeated() ? type.field(0) : nullptr;
}

/// As deep as messages are, which the parser bounds, and then the tree.
class TreeWriter {
 public:
  explicit TreeWriter(MessageTree& tree) : tree_(tree) {}

  void add_message(const pb::Message& message) {
    const pb::Descriptor& type = *message.GetDescriptor();
    if (const pb::FieldDescriptor* const value = wrapped_field(type)) {
      return add_value(message, *value, -1);
    }
    tree_.open(MessageTree::Kind::object);
    for (int i = 0; i < type.field_count(); ++i) add_field(message, *type.field(i));
    tree_.close();
  }

 private:
  void add_field(const pb::Message& message, const pb::FieldDescriptor& field) {
    const pb::Reflection& reflection = *message.GetReflection();
    const bool is_list = field.is_repeated();
    if (!is_list && has_presence(field) && !reflection.HasField(message, &field)) return;
    tree_.add_key(field.name());
    if (field.is_map()) return add_map(message, field);
    if (!is_list) return add_value(message, field, -1);
    tree_.open(MessageTree::Kind::array);
    const int count = reflection.FieldSize(message, &field);
    for (int i = 0; i < count; ++i) add_value(message, field, i);
    tree_.close();
  }

  void add_map(const pb::Message& message, const pb::FieldDescriptor& field) {
    const pb::Reflection& reflection = *message.GetReflection();
    std::vector<std::pair<std::string, const pb::Message*>> entries;
    for (int i = 0; i < reflection.FieldSize(message, &field); ++i) {
      const pb::Message& entry = reflection.GetRepeatedMessage(message, &field, i);
      entries.emplace_back(key_of(entry), &entry);
    }
    std::sort(entries.begin(), entries.end());
    tree_.open(MessageTree::Kind::object);
    for (const auto& [key, entry] : entries) {
      tree_.add_key(key);
      add_value(*entry, *entry->GetDescriptor()->field(1), -1);
    }
    tree_.close();
  }

  static std::string key_of(const pb::Message& entry) {
    const pb::Reflection& reflection = *entry.GetReflection();
    const pb::FieldDescriptor* const key = entry.GetDescriptor()->field(0);
    switch (key->cpp_type()) {
      case CppType::CPPTYPE_STRING:
        return reflection.GetString(entry, key);
      case CppType::CPPTYPE_INT32:
        return std::to_string(reflection.GetInt32(entry, key));
      case CppType::CPPTYPE_INT64:
        return std::to_string(reflection.GetInt64(entry, key));
      case CppType::CPPTYPE_UINT32:
        return std::to_string(reflection.GetUInt32(entry, key));
      case CppType::CPPTYPE_UINT64:
        return std::to_string(reflection.GetUInt64(entry, key));
      default:
        return reflection.GetBool(entry, key) ? "true" : "false";
    }
  }

  /// @param number of the element; -1: the field has one value.
  void add_value(const pb::Message& message, const pb::FieldDescriptor& field, int number) {
    const pb::Reflection& has = *message.GetReflection();
    const bool one = number < 0;
    const pb::FieldDescriptor* const of = &field;
    const auto add = [&](auto value) { tree_.add_number(static_cast<double>(value)); };
    switch (field.cpp_type()) {
      case CppType::CPPTYPE_INT32:
        return add(one ? has.GetInt32(message, of) : has.GetRepeatedInt32(message, of, number));
      case CppType::CPPTYPE_INT64:
        return tree_.add_integer(one ? has.GetInt64(message, of)
                                     : has.GetRepeatedInt64(message, of, number));
      case CppType::CPPTYPE_UINT32:
        return add(one ? has.GetUInt32(message, of) : has.GetRepeatedUInt32(message, of, number));
      case CppType::CPPTYPE_UINT64:
        return add_unsigned(one ? has.GetUInt64(message, of)
                                : has.GetRepeatedUInt64(message, of, number));
      case CppType::CPPTYPE_DOUBLE:
        return add(one ? has.GetDouble(message, of) : has.GetRepeatedDouble(message, of, number));
      case CppType::CPPTYPE_FLOAT:
        return add(one ? has.GetFloat(message, of) : has.GetRepeatedFloat(message, of, number));
      case CppType::CPPTYPE_BOOL:
        return add(one ? has.GetBool(message, of) : has.GetRepeatedBool(message, of, number));
      case CppType::CPPTYPE_ENUM:
        return add(one ? has.GetEnumValue(message, of)
                       : has.GetRepeatedEnumValue(message, of, number));
      case CppType::CPPTYPE_STRING:
        return add_text(message, field, number);
      case CppType::CPPTYPE_MESSAGE:
        return add_message(one ? has.GetMessage(message, of)
                               : has.GetRepeatedMessage(message, of, number));
    }
  }

  void add_unsigned(std::uint64_t value) {
    if (value <= std::numeric_limits<std::int64_t>::max()) {
      tree_.add_integer(static_cast<std::int64_t>(value));
    } else {
      tree_.add_number(static_cast<double>(value));
    }
  }

  void add_text(const pb::Message& message, const pb::FieldDescriptor& field, int number) {
    if (field.type() == pb::FieldDescriptor::TYPE_BYTES) return tree_.add_gap();
    const pb::Reflection& reflection = *message.GetReflection();
    std::string scratch;
    tree_.add_text(number < 0
                       ? reflection.GetStringReference(message, &field, &scratch)
                       : reflection.GetRepeatedStringReference(message, &field, number, &scratch));
  }

  MessageTree& tree_;
};

class ProtobufDecoder final : public messages::TreeDecoder {
 public:
  ProtobufDecoder(const std::string& type, std::string_view schema) : factory_(&pool_) {
    const pb::Descriptor* const found = type_in(schema, type, pool_);
    for (const pb::Descriptor* const inner : types_within(*found)) {
      largest_part_bytes_ = std::max<std::uint64_t>(largest_part_bytes_,
                                                    factory_.GetPrototype(inner)->SpaceUsedLong());
    }
    message_.reset(factory_.GetPrototype(found)->New());
  }

  void decode(std::string_view message, MessageTree& tree) override {
    if (message.size() / least_element_bytes > largest_message_bytes / largest_part_bytes_) {
      throw MessageError(fmt::format("has {} bytes, which may take more than {} in memory",
                                     message.size(), largest_message_bytes));
    }
    message_->Clear();
    if (!message_->ParsePartialFromArray(message.data(), static_cast<int>(message.size()))) {
      throw MessageError(
          fmt::format("is not one of {}", printable(message_->GetDescriptor()->full_name())));
    }
    TreeWriter(tree).add_message(*message_);
    give_back(message.size());
  }

 private:
  /// Of a message that may have taken much memory; what others took serves the next one.
  void give_back(std::size_t message_bytes) {
    constexpr std::uint64_t most_kept_bytes = std::uint64_t{1} << 20;
    if (message_bytes / least_element_bytes <= most_kept_bytes / largest_part_bytes_) return;
    message_.reset(message_->New());
  }

  pb::DescriptorPool pool_;
  pb::DynamicMessageFactory factory_;
  std::unique_ptr<pb::Message> message_;
  std::uint64_t largest_part_bytes_{1};
};

/// What is damaged is said by the program, and not by the library beside it.
void silence_library() {
#if GOOGLE_PROTOBUF_VERSION < 4022000
  pb::SetLogHandler(nullptr);
#endif
}

}  // namespace
}  // namespace tribolog::ingest::protobuf

void tribolog_protobuf_decoder(const std::string& type, std::string_view schema,
                               std::unique_ptr<tribolog::ingest::messages::TreeDecoder>& decoder) {
  tribolog::ingest::protobuf::silence_library();
  decoder = std::make_unique<tribolog::ingest::protobuf::ProtobufDecoder>(type, schema);
}
