#pragma once
// What a known logger writes into one column, told by the names that a manifest states.

#include <optional>
#include <string>

#include "joint/logged_effort.h"

namespace tribolog {

/// @param angle_column name of the joint's angle: it tells loggers apart that share a name, and has
///        to be of the same joint.
/// @return nothing where no logger that is known has both columns.
std::optional<LoggedEffort> known_effort(const std::string& angle_column,
                                         const std::string& effort_column);

}  // namespace tribolog
