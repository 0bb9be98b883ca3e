#pragma once
// Definitions of the message types that logs of joints hold, for logs that do not define them
// themselves (rosbag2 before ROS 2 Iron).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/bags/cdr_reader.h"
#include "ingest/messages/topic_tables.h"

namespace tribolog::ingest::bags {

/// @param name "sensor_msgs/JointState". @return the fields in the .msg language.
std::optional<std::string_view> known_message_type(std::string_view name);

// What a message of ROS consists of, from its definition in the .msg language, as recorders put
// it into a log: the type's own text, then the types that it uses, each after a line of `=` and a
// line `MSG: package/Type`.

struct MessageField {
  enum class Kind : std::uint8_t { number, string, message };
  enum class Count : std::uint8_t { one, fixed, sequence };
  std::string name;
  Kind kind{Kind::number};
  Primitive primitive{Primitive::float64};  ///< Of a number.
  std::size_t type{};                       ///< Of a message: its place in MessageSchema::types.
  Count count{Count::one};
  std::size_t elements{};  ///< Of a fixed array.
};

struct MessageType {
  std::string name;  ///< "sensor_msgs/JointState"
  std::vector<MessageField> fields;
};

/// No type contains itself.
struct MessageSchema {
  std::vector<MessageType> types;  ///< The first is the message's own.
};

using messages::SchemaError;

/// "sensor_msgs/msg/JointState" is "sensor_msgs/JointState".
std::string short_type_name(std::string_view type);

/// @param type the message's own type. Types that the text uses but does not define are taken from
///        those that every system has.
/// @throw SchemaError: a line that is no field, an unknown type, wstring (its size on the wire is
///        not the same everywhere), a type that contains itself.
MessageSchema parse_ros2msg(std::string_view type, std::string_view text);

/// The same of ROS 1, whose `Header` counts its messages, whose `byte` has a sign, and whose `time`
/// and `duration` are messages of `sec` and `nsec`.
MessageSchema parse_ros1msg(std::string_view type, std::string_view text);

}  // namespace tribolog::ingest::bags
