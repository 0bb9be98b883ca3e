#pragma once
// What is said of a row that cannot be used: what stands where, the likely cause, the way out.

#include <cstddef>

#include "ingest/text/csv_reader.h"
#include "ingest/text/csv_rows.h"
#include "ingest/text/number_field.h"

namespace tribolog::ingest::text {

struct RefusedRow {
  const CsvTable& table;  ///< As far as it is read.
  const RowLayout& layout;
  long line{};
};

/// @throw InputError: the row is the header once more.
[[noreturn]] void refuse_second_header(const RefusedRow& row);

/// @param found number of fields.
/// @throw InputError: it is not the header's.
[[noreturn]] void refuse_ragged_row(const RefusedRow& row, std::size_t found);

/// @param column index of the field in the file.
/// @throw InputError: the field is no number, or a number too large.
[[noreturn]] void refuse_field(const RefusedRow& row, const Field& field, std::size_t column,
                               FieldKind kind);

}  // namespace tribolog::ingest::text
