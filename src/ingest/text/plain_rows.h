#pragma once
// The rows of a text log that hold nothing but numbers and gaps: nearly all rows of nearly all
// logs. A stretch of whole lines is read without regard to what stands before it, so that stretches
// can be read side by side.

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "ingest/text/clock_field.h"
#include "ingest/text/csv_fields.h"
#include "ingest/text/number_field.h"

namespace tribolog {

/// What becomes of a column of the file.
struct PlainColumn {
  int slot{-1};  ///< Index among those read; -1: passed over.
  /// Of a clock that is read exactly: taken off.
  std::optional<ClockReading> start;
  bool is_iso_time{};  ///< That clock is written as ISO 8601.
};

struct PlainLayout {
  Delimiter delimiter{};
  DecimalMark mark{DecimalMark::point};
  std::vector<PlainColumn> columns;  ///< Of the file.
  std::size_t slots{};
};

struct PlainRows {
  /// By slot; NaN where there is a gap. The first `rows` of each have a meaning.
  std::vector<std::vector<double>> values;
  std::vector<std::size_t> gaps;  ///< By slot.
  std::size_t rows{};             ///< And as many lines.
  std::size_t bytes{};            ///< Of these rows.
  bool is_whole{};                ///< No row of the text needs a closer look.
  bool any_lf{};                  ///< Lines end with LF,
  bool any_cr_lf{};               ///< or CR LF.
};

/// Reads rows from the start of `text` until its end or the first line that is none: a blank one, a
/// comment, quotes, text, another number of fields, a lone CR, no line end.
/// @param rows is overwritten; its memory is used again.
void read_plain_rows(std::string_view text, const PlainLayout& layout, PlainRows& rows);

}  // namespace tribolog
