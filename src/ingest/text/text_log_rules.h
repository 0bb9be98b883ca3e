#pragma once
// How a text log is to be read where it cannot tell itself: what the manifest's [log] says.

#include <optional>

#include "ingest/text/csv_fields.h"
#include "ingest/text/number_field.h"

namespace tribolog {

/// Of the columns' names; numbers are ASCII in both.
enum class TextEncoding { utf8, latin1 };

struct TextLogRules {
  DecimalMark decimal_mark{DecimalMark::point};
  std::optional<Delimiter> delimiter;  ///< Absent: found out.
  TextEncoding encoding{TextEncoding::utf8};
  /// Line of the columns' names, or of the first row where there are none; counts from 1. What
  /// stands in front of it is not read. Absent: the first line that is no comment.
  std::optional<long> header_line;
  /// Rows that cannot be used are left out and counted, up to `most_bad_rows` of all.
  bool skip_bad_rows{};
};

/// Share of the rows. A log with more is damaged, or not what the manifest says.
inline constexpr double most_bad_rows = 0.01;

}  // namespace tribolog
