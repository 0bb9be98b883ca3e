#pragma once
// Friction models as tables of a TOML file: one key a parameter, named as in the model's header.

#include "friction/lugre.h"
#include "friction/waiboer.h"
#include "ingest/toml_table.h"

namespace tribolog {

/// @throw InputError for a parameter that is missing, impossible or unknown.
LuGreFriction read_lugre(const TomlTable& table);

/// smoothing_s_rad may be left out: 1e6. @throw InputError as above.
WaiboerFriction read_waiboer(const TomlTable& table);

}  // namespace tribolog
