#pragma once
// [[known_load]] and [known_gravity] of a manifest.

#include <optional>
#include <vector>

#include "ingest/manifest/toml_table.h"
#include "joint/known_load.h"

namespace tribolog {

/// All tables [[known_load]]; none: empty.
/// @throw InputError for a missing, unknown or impossible key, or a role that does not exist.
std::vector<KnownLoad> read_known_loads(const TomlTable& top);

/// @throw InputError for a missing, unknown or impossible key.
std::optional<StatedGravity> read_known_gravity(const TomlTable& top);

}  // namespace tribolog
