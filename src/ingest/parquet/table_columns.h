#pragma once
// Columns of a log's table from the values of a Parquet column.

#include <string>
#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/parquet/column_values.h"
#include "ingest/parquet/leaf_columns.h"

namespace tribolog::ingest::parquet {

struct TableColumns {
  std::vector<log::LogColumn> columns;  ///< Without names.
  bool was_rounded{};                   ///< Held integers that no double holds exactly.
};

/// One for each element of a row. A clock's are counted from the first reading, exactly.
/// @param values which are no longer there then.
TableColumns table_columns(const LeafColumn& leaf, ColumnValues& values);

}  // namespace tribolog::ingest::parquet
