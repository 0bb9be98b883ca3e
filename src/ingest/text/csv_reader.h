#pragma once
// Columns of numbers from a log in CSV or a dialect of it.
//
// Accepted: UTF-8 with or without byte order mark; lines ending with LF, CR LF or CR; comma,
// semicolon, tab or blanks between the columns (found out, or stated, and returned in `delimiter`);
// one header row with the columns' names, units in brackets allowed, or in a row of their own
// below; names in a comment above the first row; none, if columns are asked for by their position,
// and of what `ros2 topic echo --csv` writes; a first line "sep=;"; quoted fields within a line;
// comments with `#`, `%` and `//`; blank lines; a delimiter after the last column. Numbers are read
// the same under every locale, with a decimal point unless commas are stated. Empty fields, nan,
// inf, null, dashes and the like are gaps. A last row without line end that is cut off is left out
// and counted. Everything else is refused with the line and column where it stands.

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/input_file.h"
#include "ingest/log/log_table.h"
#include "ingest/text/csv_dialect.h"

namespace tribolog::ingest::text {

struct CsvTable : log::LogTable {
  Delimiter delimiter{Delimiter::comma};
};

/// Holds a few megabytes of the log at a time, and the columns asked for.
/// @param file its name, for messages.
/// @param columns those to convert, none twice; the others are counted but not read. None at all:
/// every one that holds numbers, times, or words alone in the first rows; the others are named in a
/// note.
/// @param rules what the log cannot tell itself.
/// @throw InputError with file:line:column, what was found, what was expected and what to do.
CsvTable read_csv(ByteSource& bytes, const std::string& file,
                  const std::vector<log::WantedColumn>& columns, const TextLogRules& rules = {});
/// Whether the log's numbers have decimal commas beyond doubt (csv_dialect.h); its first rows are
/// looked at, by rules without a decimal comma.
bool shows_decimal_commas(ByteSource& bytes, const std::string& file,
                          const TextLogRules& rules = {});

/// The same of a log in memory.
CsvTable read_csv(std::string_view bytes, const std::string& file,
                  const std::vector<log::WantedColumn>& columns, const TextLogRules& rules = {});

}  // namespace tribolog::ingest::text
