#pragma once
// How a text log is to be read where it cannot tell itself: what the manifest's [log] says.

#include <optional>

#include "ingest/text/csv_fields.h"
#include "ingest/text/number_field.h"

namespace tribolog {

class TomlTable;

struct TextLogRules {
  DecimalMark decimal_mark{DecimalMark::point};
  std::optional<Delimiter> delimiter;  ///< Absent: found out.
};

/// [log] decimal_comma = false, delimiter = "comma" | "semicolon" | "tab" | "spaces".
/// @throw InputError for an unknown key, or commas for both.
TextLogRules read_text_log_rules(const TomlTable& log);

}  // namespace tribolog
