#pragma once
// The data rows of a log, once delimiter and header are known.

#include <string_view>
#include <vector>

#include "ingest/text/csv_lines.h"
#include "ingest/text/csv_reader.h"
#include "ingest/text/number_field.h"

namespace tribolog::ingest::text {

/// What the rows are read against.
struct RowLayout {
  std::vector<Field> header;
  std::string header_row;  ///< As it stands in the file; empty: there is none.
  std::vector<int> slots;  ///< For each column of the file: index in `columns`, or -1.
  std::vector<log::ColumnReading> readings;  ///< Of each of `columns`.
  DecimalMark mark{DecimalMark::point};
  bool skip_bad_rows{};  ///< Leaves out and counts what is refused otherwise.
};

/// Reads every row that the cursor has not passed yet into the table's columns.
/// @throw InputError at the first field or row that cannot be used; where those are skipped, if
///        there are too many.
void read_rows(RowCursor& cursor, const RowLayout& layout, CsvTable& table);

}  // namespace tribolog::ingest::text
