#pragma once
// Definitions of the message types that logs of joints hold, for logs that do not define them
// themselves (rosbag2 before ROS 2 Iron).

#include <optional>
#include <string_view>

namespace tribolog {

/// @param name "sensor_msgs/JointState". @return the fields in the .msg language.
std::optional<std::string_view> known_message_type(std::string_view name);

}  // namespace tribolog
