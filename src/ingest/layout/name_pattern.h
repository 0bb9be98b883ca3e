#pragma once
// Names of columns that differ by the joint alone: "actual_q_0", "state.q[3]", "elbow.position".

#include <optional>
#include <string>
#include <string_view>

namespace tribolog {

/// @param pattern with one "{}" for the joint, or none. Case does not count.
/// @return what stands for the joint (empty for a pattern without one), or nothing where the name
/// does not fit.
std::optional<std::string> joint_in_name(std::string_view name, std::string_view pattern);

}  // namespace tribolog
