#pragma once
// Columns of numbers from a log in CSV or a dialect of it.
//
// Accepted: UTF-8 with or without byte order mark; lines ending with LF, CR LF or CR; comma,
// semicolon, tab or blanks between the columns (found out, and stated in `delimiter`); one header
// row with the columns' names, units in brackets allowed; quoted fields within a line; comments
// with
// `#`; blank lines; a delimiter after the last column. Numbers are read the same under every
// locale. Empty fields, nan, inf, null and the like are gaps. A last row without line end that is
// cut off is left out and counted. Everything else is refused with the line and column where it
// stands.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "error.h"
#include "ingest/csv_dialect.h"

namespace tribolog {

/// A column to convert.
struct WantedColumn {
  std::string name;          ///< With or without its bracketed unit.
  std::string if_missing{};  ///< Added to the hint where there is no such column.
};

struct CsvColumn {
  ColumnHeader header;
  std::vector<double> values;  ///< NaN where there is a gap.
  std::size_t gaps{};
};

struct CsvTable {
  std::string file;
  Delimiter delimiter{Delimiter::comma};
  std::vector<std::string> header;  ///< All columns of the file, in full.
  std::vector<CsvColumn> columns;   ///< Those asked for, in that order.
  std::size_t rows{};               ///< Of each column.
  std::size_t cut_rows{};           ///< 1 where the file ends inside a row, which is left out.
  std::vector<std::string> notes;   ///< Peculiarities that the user should know.

  /// Line of the file on which a row (from 0) stands.
  [[nodiscard]] long line_of(std::size_t row) const;
  /// (row, line) wherever a row does not follow directly on the line before it; ascending.
  std::vector<std::pair<std::size_t, long>> line_breaks;
};

/// @param bytes the whole file. @param file its name, for messages.
/// @param columns those to convert, none twice; the others are counted but not read.
/// @throw InputError with file:line:column, what was found, what was expected and what to do.
CsvTable read_csv(std::string_view bytes, const std::string& file,
                  const std::vector<WantedColumn>& columns);

}  // namespace tribolog
