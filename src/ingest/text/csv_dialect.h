#pragma once
// How a log separates its columns, and what its header says.

#include <string>
#include <string_view>

#include "ingest/log/log_table.h"
#include "ingest/text/csv_fields.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/number_field.h"

namespace tribolog {

/// "commas", "semicolons", "tabs", "spaces"
std::string to_string(Delimiter delimiter);

/// The delimiter under which the header and the first rows have the same number of columns.
/// @param mark with a decimal comma, commas are none.
/// @throw InputError if two delimiters fit equally well.
Delimiter sniff_delimiter(std::string_view text, const std::string& file,
                          DecimalMark mark = DecimalMark::point);
/// The same from the header on, in front of which the cursor stands.
Delimiter sniff_delimiter(RowCursor cursor, const std::string& file, DecimalMark mark);

/// The name and the unit in brackets behind it.
ColumnHeader read_header_field(const std::string& field);

}  // namespace tribolog
