#pragma once
// The [log] table of a manifest.

#include "ingest/manifest/toml_table.h"
#include "ingest/text/text_log_rules.h"

namespace tribolog {

/// [log] decimal_comma = false, delimiter = "comma" | "semicolon" | "tab" | "spaces",
///       encoding = "utf8" | "latin1", header_line = 7, skip_bad_rows = false.
/// @throw InputError for an unknown key, or commas for both.
TextLogRules read_text_log_rules(const TomlTable& log);

}  // namespace tribolog
