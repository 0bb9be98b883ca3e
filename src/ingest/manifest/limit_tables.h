#pragma once
// The acceptance limits of a manifest:
//
//   [[limit]]
//   quantity = "coulomb_joint_Nm"    # one of limited_quantities(), the unit in its name
//   max = 15.0                       # of these four one or more
//   min = 5.0
//   half_width = 0.5                 # largest half width of the 95 % interval
//   half_width_percent = 5           # the same, of the estimate

#include <vector>

#include "ingest/manifest/toml_table.h"
#include "joint/acceptance_limit.h"

namespace tribolog {

/// @throw InputError for an unknown quantity (with the closest known one), a limit without a
///        number, min above max, or a width that is not positive.
std::vector<AcceptanceLimit> read_limits(const TomlTable& manifest);

}  // namespace tribolog
