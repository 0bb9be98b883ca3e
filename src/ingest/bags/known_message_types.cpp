#include "ingest/bags/known_message_types.h"

#include <array>
#include <utility>

namespace tribolog {

std::optional<std::string_view> known_message_type(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> types = {{
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
      {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
      {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
      {"std_msgs/Float64", "float64 data\n"},
      {"sensor_msgs/JointState",
       "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\n"
       "float64[] effort\n"},
      {"sensor_msgs/Temperature",
       "std_msgs/Header header\nfloat64 temperature\nfloat64 variance\n"},
      {"control_msgs/InterfaceValue", "string[] interface_names\nfloat64[] values\n"},
      {"control_msgs/DynamicJointState",
       "std_msgs/Header header\nstring[] joint_names\nInterfaceValue[] interface_values\n"},
  }};
  for (const auto& [type, text] : types) {
    if (type == name) return text;
  }
  return std::nullopt;
}

}  // namespace tribolog
