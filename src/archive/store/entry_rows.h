#pragma once
// Internal to the store: what an archive holds, to and from the rows of its tables.

#include <string>
#include <vector>

#include "archive/archived_calibration.h"
#include "archive/sql/sql_value.h"

namespace tribolog::archive {

/// Of the table calibration, in the order of entry_of(): "number, id, ...".
extern const char* const entry_columns;
Entry entry_of(const sql::Row& row);
/// All but the number.
std::vector<sql::Value> values_of(const Entry& entry);

/// Of the table quantity: "name, words, ...".
extern const char* const quantity_columns;
/// @param first where the columns begin.
Quantity quantity_of(const sql::Row& row, std::size_t first = 0);

std::string to_string(DocumentKind kind);

}  // namespace tribolog::archive
