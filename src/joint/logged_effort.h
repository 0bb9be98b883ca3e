#pragma once
// What a logger is known to write into the column that a manifest takes for the effort.

#include <optional>
#include <string>

#include "joint/drive.h"

namespace tribolog {

struct LoggedEffort {
  std::string logger;              ///< "UR RTDE"
  std::string column;              ///< "target_moment_0"
  std::optional<EffortKind> kind;  ///< Absent: the logger writes one or the other.
  std::optional<Side> side;
  bool is_target{};       ///< A set point or a model's value: no measurement.
  bool is_behind_gear{};  ///< Of a sensor that most of the gear's friction does not pass.
};

}  // namespace tribolog
