#pragma once
// Tables of a manifest: known loads, limits, and how its logs are to be read.

#include <optional>
#include <vector>

#include "ingest/manifest/toml_table.h"
#include "ingest/text/csv_dialect.h"
#include "joint/dataset.h"
#include "joint/gravity_load.h"

namespace tribolog::ingest::manifest {

/// All tables [[known_load]]; none: empty.
/// @throw InputError for a missing, unknown or impossible key, or a role that does not exist.
std::vector<joint::KnownLoad> read_known_loads(const TomlTable& top);

/// @throw InputError for a missing, unknown or impossible key.
std::optional<joint::StatedGravity> read_known_gravity(const TomlTable& top);

// The acceptance limits of a manifest:
//
//   [[limit]]
//   quantity = "coulomb_joint_Nm"    # one of limited_quantities(), the unit in its name
//   max = 15.0                       # of these four one or more
//   min = 5.0
//   half_width = 0.5                 # largest half width of the 95 % interval
//   half_width_percent = 5           # the same, of the estimate

/// @throw InputError for an unknown quantity (with the closest known one), a limit without a
///        number, min above max, or a width that is not positive.
std::vector<joint::AcceptanceLimit> read_limits(const TomlTable& manifest);

// The [log] table of a manifest.

/// [log] decimal_comma = false, delimiter = "comma" | "semicolon" | "tab" | "spaces",
///       encoding = "utf8" | "latin1", header_line = 7, skip_bad_rows = false.
/// @throw InputError for an unknown key, or commas for both.
text::TextLogRules read_text_log_rules(const TomlTable& log);

}  // namespace tribolog::ingest::manifest
