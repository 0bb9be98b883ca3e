#pragma once
// Loggers that are known by the names of their columns, and what they write into them.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ingest/log/units.h"
#include "joint/dataset.h"
#include "joint/drive.h"

namespace tribolog::ingest::layout {

struct KnownColumn {
  std::string_view pattern;  ///< See joint_in_name().
  log::Quantity quantity{};
  std::string_view unit;
  bool is_target{};
  std::optional<joint::EffortKind> kind{};
  std::optional<joint::Side> side{};
  std::string_view remark{};
  bool is_behind_gear{};  ///< Of a sensor that most of the gear's friction does not pass.
};

struct KnownLogger {
  std::string_view name;
  std::string_view told_by;  ///< A column that no other logger has; a pattern.
  std::span<const KnownColumn> columns;
};

/// The more particular ones first.
std::span<const KnownLogger> known_loggers();

// What a known logger writes into one column, told by the names that a manifest states.

/// @param angle_column name of the joint's angle: it tells loggers apart that share a name, and has
///        to be of the same joint.
/// @return nothing where no logger that is known has both columns.
std::optional<joint::LoggedEffort> known_effort(const std::string& angle_column,
                                                const std::string& effort_column);

}  // namespace tribolog::ingest::layout
