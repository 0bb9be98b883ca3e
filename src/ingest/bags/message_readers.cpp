#include "ingest/bags/message_readers.h"

#include <string>
#include <utility>

#include "base/error.h"
#include "ingest/bags/json_messages.h"
#include "ingest/bags/protobuf_module.h"
#include "ingest/bags/rosmsg_schema.h"
#include "ingest/bags/schema_columns.h"

namespace tribolog::ingest::bags {
namespace {

using messages::MessageReader;
using messages::TopicDescription;

void check_schema(const TopicDescription& topic, const char* encoding) {
  if (topic.schema_encoding == encoding) return;
  if (topic.schema_encoding.empty()) {
    const std::string what = topic.type.empty() ? "its messages consist" : topic.type + " consists";
    throw SchemaError("the log does not say what " + printable(what) + " of");
  }
  throw SchemaError(printable(topic.type) + " is defined in '" + printable(topic.schema_encoding) +
                    "', not in " + encoding);
}

MessageSchema schema_of_cdr(const TopicDescription& topic) {
  if (topic.schema_encoding != "ros2msg") {
    if (const auto known = known_message_type(short_type_name(topic.type))) {
      return parse_ros2msg(topic.type, *known);
    }
  }
  check_schema(topic, "ros2msg");
  return parse_ros2msg(topic.type, topic.schema);
}

}  // namespace

std::unique_ptr<MessageReader> reader_of(const TopicDescription& topic) {
  const std::string& encoding = topic.message_encoding;
  if (encoding == "cdr") {
    return std::make_unique<SchemaReader>(schema_of_cdr(topic), Serialization::cdr);
  }
  if (encoding == "ros1") {
    check_schema(topic, "ros1msg");
    return std::make_unique<SchemaReader>(parse_ros1msg(topic.type, topic.schema),
                                          Serialization::ros1);
  }
  if (encoding == "json") return messages::reader_of_trees(std::make_unique<JsonDecoder>());
  if (encoding == "protobuf") {
    check_schema(topic, "protobuf");
    return messages::reader_of_trees(protobuf_decoder(topic.type, topic.schema));
  }
  throw SchemaError("messages are encoded as '" + printable(encoding) +
                    "', not as cdr, ros1, json or protobuf");
}

}  // namespace tribolog::ingest::bags
